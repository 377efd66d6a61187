#include <session.hpp>

int example::run_xy_table(const configuration& c, const session_options& options) {
  return run_session(ph::xy_table<double>(c.xy_table), c, options);
}
