// Two links in a plane, a brake on each joint (Figs. 2 and 3).
#include "two_links.hpp"

namespace explorer {
namespace {

struct description : two_links {
  using mechanism = ph::two_link<double>;
  using parameters = ph::two_link_parameters<double>;
  static constexpr const char *id = "two_link", *label = "Two links";

  static mechanism make(const parameters& p) { return mechanism(p); }
  static void draw(const mechanism& model, const joints& q, drawing& to) {
    const auto at = points(model, q);
    const double size = brake_share * max_link_length(model);
    draw_links(to, at, size);
    for (int i = 0; i < 2; ++i)
      to.add_turning(item_kind::brake, i, at[std::size_t(i)], out_of_plane(), size, q[i]);
  }
};

}  // namespace

mechanism_entry two_link_entry() { return entry_of<description>(); }

}  // namespace explorer
