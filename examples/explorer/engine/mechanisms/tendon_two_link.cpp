// The paper's device: two links, both brakes at the base, coupled by a tendon (Fig. 7).
#include "two_links.hpp"

#include <passive_haptics/mechanism/models/tendon_two_link.hpp>

namespace explorer {
namespace {

struct description : two_links {
  using mechanism = ph::tendon_two_link<double>;
  using parameters = ph::tendon_two_link_parameters<double>;
  static constexpr const char *id = "tendon_two_link", *label = "The paper's device: two links and a tendon";

  static mechanism make(const parameters& p) { return mechanism(p); }

  // The two outer tangents of pulleys of radii r at a and s at b, in the plane.
  static void add_belt(drawing& to, int brake, const drawing::place& a, double r, const drawing::place& b,
                       double s) {
    const ph::vector<double, 2> apart(b[0] - a[0], b[1] - a[1]);
    const double distance = apart.norm();
    if (!(distance > std::abs(r - s))) return;
    const ph::vector<double, 2> u = apart / distance, left(-u[1], u[0]);
    const double sine = (r - s) / distance, cosine = std::sqrt(1 - sine * sine);
    for (const double side : {1.0, -1.0}) {
      const ph::vector<double, 2> out = sine * u + side * cosine * left;
      const drawing::place away(out[0], out[1], 0);
      to.add(item_kind::belt, brake, a + r * away, b + s * away);
    }
  }

  static void draw(const mechanism& model, const joints& q, drawing& to) {
    const auto at = points(model, q);
    const double size = brake_share * max_link_length(model);
    draw_links(to, at, size);
    // The larger pulley of the reduction has the drawn size: k2 is the ratio of the radii
    const double k2 = 1 / model.transmission()(1, 1);
    const double base = size * std::min(1.0, k2), elbow = size * std::min(1.0, 1 / k2);
    const ph::vector<double, 2> w = model.transmission() * q;  // how far the brakes' axes turned
    add_belt(to, 1, at[0], base, at[1], elbow);
    to.add_turning(item_kind::pulley, 1, at[0], out_of_plane(), base, w[1]);
    to.add_turning(item_kind::pulley, 1, at[1], out_of_plane(), elbow, q[0] + q[1]);
    to.add_turning(item_kind::brake, 0, at[0], out_of_plane(), size, w[0]);
    to.add_turning(item_kind::brake, 1, at[0], out_of_plane(), size / 2, w[1]);
  }
};

}  // namespace

mechanism_entry tendon_two_link_entry() { return entry_of<description>(); }

}  // namespace explorer
