#include <session.hpp>

int example::run_five_bar(const configuration& c, const session_options& options) {
  return run_session(ph::five_bar<double>(c.five_bar), c, options);
}
