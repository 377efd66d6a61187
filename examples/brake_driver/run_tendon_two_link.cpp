#include <session.hpp>

int example::run_tendon_two_link(const configuration& c, const session_options& options) {
  return run_session(ph::tendon_two_link<double>(c.tendon_two_link), c, options);
}
