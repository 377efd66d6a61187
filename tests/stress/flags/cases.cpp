// The same fixed cycles in every build: `cases write FILE` notes what came out, `cases compare FILE` holds
// this build against it. Torques agree to rounding of the terms that they are made of; classes agree unless
// some quantity that decides is within rounding of its boundary, which is counted.
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/pipelines/several_walls.hpp>
#include <passive_haptics/control/step.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <vector>

namespace {

namespace ph = passive_haptics;
using device = ph::tendon_two_link<double>;

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr int cases = 100000;
constexpr double boundary = 64 * eps;  // relative distance under which a class may change
constexpr double agreement = 8 * eps;  // of torques, relative to their terms

// What one build says of a case.
struct record {
  double torque[2];
  double terms;     // [N m] size of what the torques are made of
  double distance;  // of the nearest deciding quantity from its boundary, relative to its terms
  std::int8_t region[2], power, display;
};

// The same everywhere: integer arithmetic and exact conversions only.
class source {
 public:
  double unit() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state_ >> 11) * 0x1p-53;
  }
  double symmetric() { return 2 * unit() - 1; }
  double size(int low, int high) {
    const int exponent = low + static_cast<int>(unit() * (high - low));
    return std::ldexp(1 + unit(), exponent);
  }
  bool one_in(int n) { return unit() * n < 1; }

 private:
  std::uint64_t state_ = 20040627;
};

record run(const device& arm, source& random) {
  ph::device_state<device> state;
  state.time = 0;
  state.q = {3 * random.symmetric(), random.one_in(8) ? 0 : 3 * random.symmetric()};
  state.qd = {random.symmetric(), random.symmetric()};
  if (random.one_in(8)) state.qd[0] = 0.02;                        // the dead band
  if (random.one_in(8)) state.qd[1] = 0.4 * (0.02 - state.qd[0]);  // that of brake 2, to rounding
  state.hand_force = {random.symmetric(), random.symmetric()};
  // Rational points of the circle: no sine whose last digit a compiler could choose
  const double u = random.symmetric(), v = random.one_in(2) ? 1 : -1;
  ph::contact<2> wall;
  wall.normal = v * ph::point<2>(1 - u * u, 2 * u) / (1 + u * u);
  if (random.one_in(8)) wall.normal = {0, v};
  wall.depth = random.size(-20, -7);
  wall.stiffness = random.size(0, 24);
  ph::contacts<2, 1> touched;
  touched.push_back(wall);
  const ph::brakes_of<device> brakes;
  ph::step_memory<ph::direct_control> memory;
  const auto result = ph::step(arm, brakes, touched, ph::direct_control(), state, memory);

  // How near the decisions were
  const ph::matrix<double, 2, 2> E = ph::brake_jacobian(arm, state.q);
  const ph::vector<double, 2> w = ph::brake_rates(arm, state.q, state.qd);
  const ph::vector<double, 2> t = E.transpose() * wall.normal, th = E.transpose() * state.hand_force;
  record r{};
  const auto decides = [&](double x, double limit, double terms) {
    r.distance = std::min(r.distance, std::abs(std::abs(x) - limit) / terms);
  };
  r.distance = 1;
  const double rates = state.qd.cwiseAbs().sum() * 2.5 + 0.02, size = E.norm();
  for (int i = 0; i < 2; ++i) {
    decides(w[i], 0.02, rates);
    decides(t[i], 0, size);
    decides(th[i], 1e-9, size * state.hand_force.norm());
    r.torque[i] = result.torque[i];
    r.region[i] = static_cast<std::int8_t>(result.signs[i]);
  }
  decides(t.dot(w), 0, size * rates);
  decides(result.approximation_cosine, ph::step_options<double>().min_cosine, 1);
  r.power = static_cast<std::int8_t>(result.power);
  r.display = static_cast<std::int8_t>(result.display);
  // The share of Fc that is commanded, and the hand's part in alpha and in the torque of a brake at rest
  const double F = result.control_force.norm(), hand = state.hand_force.norm();
  double share = 0;
  for (int i = 0; i < 2; ++i)
    if (result.capacity[i] > 0)
      share = std::max(share, result.capacity[i] / std::abs(result.cone_coefficients[i]));
  r.terms = size * hand;
  if (F > 0) r.terms += size * F * (share + hand / result.desired_force.norm()) / result.approximation_cosine;
  return r;
}

bool same_classes(const record& a, const record& b) {
  return std::memcmp(a.region, b.region, sizeof a.region) == 0 && a.power == b.power &&
         a.display == b.display;
}

int compare(const std::vector<record>& ours, const std::vector<record>& theirs) {
  int near = 0, differ_near = 0, bad = 0, displayed = 0;
  double worst = 0;
  for (std::size_t k = 0; k < ours.size(); ++k) {
    const record &a = ours[k], &b = theirs[k];
    const bool at_boundary = std::min(a.distance, b.distance) < boundary;
    near += at_boundary;
    if (!same_classes(a, b)) {
      differ_near += at_boundary;
      if (!at_boundary && bad++ < 3)
        std::printf("case %zu: another class at a distance of %.1e from its boundary\n", k, a.distance);
      continue;
    }
    displayed += a.torque[0] != 0 || a.torque[1] != 0;
    for (int i = 0; i < 2; ++i) {
      const double off = std::abs(a.torque[i] - b.torque[i]) / std::max(a.terms, b.terms);
      if (!at_boundary) worst = std::max(worst, off);
      if (!at_boundary && !(off <= agreement) && bad++ < 3)
        std::printf("case %zu: torque %.17g N m instead of %.17g, %.1f eps of its terms\n", k, a.torque[i],
                    b.torque[i], off / eps);
    }
  }
  std::printf(
      "%zu cases, %d with torque: torques within %.1f eps of their terms; %d within %.0f eps of a boundary, "
      "%d of them in another class; %d contradict\n",
      ours.size(), displayed, worst / eps, near, boundary / eps, differ_near, bad);
  return bad == 0 && displayed > cases / 4 ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) return std::fprintf(stderr, "usage: cases write|compare FILE\n"), 2;
  const bool writes = std::strcmp(arguments[1], "write") == 0;
  const device arm;
  source random;
  std::vector<record> ours, theirs(cases);
  for (int k = 0; k < cases; ++k) ours.push_back(run(arm, random));
  std::FILE* file = std::fopen(arguments[2], writes ? "wb" : "rb");
  if (file == nullptr) return std::perror(arguments[2]), 2;
  const std::size_t done = writes ? std::fwrite(ours.data(), sizeof(record), cases, file)
                                  : std::fread(theirs.data(), sizeof(record), cases, file);
  if (std::fclose(file) != 0 || done != cases)
    return std::fprintf(stderr, "%s: %zu of %d cases\n", arguments[2], done, cases), 2;
  return writes ? 0 : compare(ours, theirs);
}
