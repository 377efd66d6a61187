#include "wide_devices.hpp"

#include "batch.hpp"
#include "markdown.hpp"
#include "random_plane.hpp"
#include "rods.hpp"

#include <passive_haptics/design/undisplayable_share.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace experiments {

namespace {

// What came of one device.
struct outcome {
  ph::contact_metrics figures;
  bool held = false;  // its residual torque alone keeps the hand off the wall
  // Shares of the way on which nothing can be displayed, and less than the hand pushes with at 10 mm
  double nothing = 0, weak = 0;
};

// How a kind of device is made, its inertia s times the nominal one, and where it is used.
template <class M>
struct kind {
  const char* name;
  M (*make)(double s);
  ph::workspace<M> where;
};

// Share of the way along the surface on which the brakes cannot display this push [N].
template <class M>
double share_without(const M& real, const kind<M>& k, const ph::random_device<M>& d, double push) {
  ph::joint_vector<M> q = d.plane.q;
  const auto path = [&](double u) {
    const ph::task_vector<M> x = d.plane.surface + u * k.where.path_length * d.plane.direction;
    ph::reach(real, k.where, x, q);
    return ph::path_point<M>{q, d.plane.direction, d.plane.normal};
  };
  ph::brake_vector<M> limits;
  for (int i = 0; i < M::brake_count; ++i) limits[i] = d.brakes[static_cast<std::size_t>(i)].torque_limit;
  return ph::undisplayable_share<M>(real, path, limits, push, 40);
}

// A controller whose commands come this many cycles late.
template <class Control>
class late {
 public:
  late(Control control, std::size_t cycles) : control_(std::move(control)), results_(cycles + 1) {}
  template <class State>
  const auto& operator()(const State& state) {
    results_[now_] = control_(state);
    now_ = (now_ + 1) % results_.size();
    return results_[now_];
  }

 private:
  Control control_;
  std::vector<typename Control::result_type> results_;
  std::size_t now_ = 0;
};

template <class M>
ph::contact_metrics follow_under_law(const kind<M>& k, const ph::random_device<M>& d, std::uint64_t seed,
                                     std::size_t number, belief what,
                                     const ph::velocity_direct_control_parameters& constants = {}) {
  auto brakes = d.known_brakes;
  double inertia = 1;
  std::size_t late_cycles = 0;
  if (what != belief::data_sheet) {
    std::mt19937_64 bits = ph::random_bits(seed + 1, number);  // others than those of the device
    brakes.time_constant *= 0.3 * std::pow(10.0, ph::uniform_number(bits));
    inertia = d.inertia * 0.5 * std::pow(4.0, ph::uniform_number(bits));
    constexpr double max_dead_time = 0.010;  // [s]
    if (what == belief::extreme)
      late_cycles = static_cast<std::size_t>(
          std::lround(max_dead_time * ph::uniform_number(bits) / d.run.control_period));
  }
  const auto control = velocity_control(k.make(inertia), brakes, d, constants);
  return follow_plane<M>(k.make(d.inertia), d.brakes, d, late(control, late_cycles));
}

template <class M>
outcome follow_one(const kind<M>& k, std::uint64_t seed, std::size_t number, belief what, double time_step) {
  auto d = ph::draw_device(k.make(1), k.where, seed, number);
  d.run.time_step = time_step;
  const M real = k.make(d.inertia);
  outcome o{follow_under_law(k, d, seed, number, what)};
  if (o.figures.separates() || o.figures.floats() || o.figures.never_touches())
    o.held = is_held(real, d.brakes, d);
  if (o.figures.is_deep()) {
    const double push = d.hand.push + d.hand.normal_stiffness * (d.hand.target_depth - 0.01);
    o.nothing = share_without(real, k, d, 0);
    o.weak = share_without(real, k, d, std::max(push, 0.0));
  }
  return o;
}

template <class M>
wide_row follow_all(const kind<M>& k, std::uint64_t seed, std::size_t count, belief what, double time_step) {
  const auto outcomes = on_all_cores(std::string("wide devices: ") + k.name, count,
                                     [&](std::size_t j) { return follow_one(k, seed, j, what, time_step); });
  wide_row row;
  row.device = k.name;
  row.count = count;
  std::vector<double> spread;
  for (const outcome& o : outcomes) {
    row.max_power = std::max(row.max_power, o.figures.max_brake_power);
    if (o.held) {
      ++row.held;
      continue;
    }
    row.separating += o.figures.separates();
    row.floating += o.figures.floats();
    row.never += o.figures.never_touches();
    row.deep += o.figures.is_deep();
    if (o.nothing > 0.1) ++row.deep_nothing;
    else if (o.weak > 0.1) ++row.deep_weak;
    if (!o.figures.is_deep()) spread.push_back(o.figures.depth_std);
  }
  row.median_std = median(spread);
  return row;
}

using tendon = ph::tendon_two_link<double>;

ph::delta<double> delta_of(double s) {
  ph::delta_parameters<double> p;
  p.upper_arm_mass *= s;
  p.forearm_mass *= s;
  p.platform_mass *= s;
  p.rotor_inertia *= s;
  return ph::delta<double>(p);
}

template <int Brakes>
ph::five_bar<double, Brakes> five_bar_of(double s) {
  ph::five_bar_parameters<double, Brakes> p;
  p.proximal_mass *= s;
  p.distal_mass *= s;
  p.handle_mass *= s;
  p.rotor_inertia *= s;
  return ph::five_bar<double, Brakes>(p);
}

ph::xy_table<double> table_of(double s) {
  ph::xy_table_parameters<double> p;
  p.mass_x *= s;
  p.mass_y *= s;
  return ph::xy_table<double>(p);
}

const kind<tendon> tendons{"tendon", tendon_of, {{-3.1, -2.5}, {3.1, -0.6}, 0.1}};

// Separating ones of 300 tendon devices, and the median of their largest depths [m].
std::pair<int, double> separating(std::uint64_t seed, belief what, double rest_depth) {
  ph::device_ranges ranges;
  if (what == belief::extreme) {
    ranges.gain = {0.5, 1.5};
    ranges.rise_time_constant = {0.001, 0.1};
  }
  const auto figures = on_all_cores("depths of rest", 300, [&](std::size_t number) -> ph::contact_metrics {
    auto d = ph::draw_device(tendon_of(1), tendons.where, seed, number, ranges);
    d.run.time_step = 2e-4;
    return follow_under_law(tendons, d, seed, number, what, {.rest_depth = rest_depth});
  });
  std::vector<double> max_depth;
  int count = 0;
  for (const ph::contact_metrics& f : figures) {
    count += f.separates();
    max_depth.push_back(f.max_depth);
  }
  return {count, median(max_depth)};
}

}  // namespace

std::vector<rest_depth_row> follow_at_rest_depths() {
  constexpr std::uint64_t first_seed = 20261, second_seed = 31337;
  std::vector<rest_depth_row> rows;
  for (const double depth : {1e-3, 2e-3, 4e-3}) {
    const auto [known, max_depth] = separating(first_seed, belief::data_sheet, depth);
    rows.push_back({depth, known, separating(second_seed, belief::data_sheet, depth).first,
                    separating(first_seed, belief::wrong, depth).first,
                    separating(first_seed, belief::extreme, depth).first, max_depth});
  }
  return rows;
}

std::string rest_depth_table(const std::vector<rest_depth_row>& rows) {
  std::string table = markdown_head({"depth of rest [mm]", "separating of 300", "other 300", "wrong beliefs",
                                     "extreme devices, wrong beliefs", "median of the largest depths [mm]"});
  for (const rest_depth_row& r : rows)
    table += markdown_row({written("%g", 1e3 * r.rest_depth), written("%d", r.first_seed),
                           written("%d", r.second_seed), written("%d", r.wrong), written("%d", r.extreme),
                           written("%.1f", 1e3 * r.median_max_depth)});
  return table;
}

std::vector<wide_row> follow_with_wide_devices(std::uint64_t seed, belief what, double share,
                                               double time_step) {
  const auto count = [&](double all) { return static_cast<std::size_t>(std::ceil(share * all)); };
  const std::size_t few = count(60);
  const kind<ph::delta<double>> deltas{"delta", delta_of, {{-0.2, -0.2, -0.2}, {1.1, 1.1, 1.1}, 0.05}};
  const kind<arm_3r> arms{"3R arm", arm_3r_of, {{-3, 0, -2.4}, {3, 1.6, -0.6}, 0.1}};
  const kind<ph::five_bar<double, 2>> fives{"five-bar", five_bar_of<2>, {{1.5, 0}, {3.1, 1.6}, 0.04}};
  const kind<ph::five_bar<double, 4>> four_brakes{
      "five-bar, four brakes", five_bar_of<4>, {{1.5, 0}, {3.1, 1.6}, 0.04}};
  const kind<ph::xy_table<double>> tables{"XY table", table_of, {{-0.1, -0.1}, {0.1, 0.1}, 0.1, 0.1}};
  const auto all = [&](const auto& k, std::size_t n) { return follow_all(k, seed, n, what, time_step); };
  return {all(tendons, count(300)), all(deltas, few),      all(arms, few),
          all(fives, few),          all(four_brakes, few), all(tables, few)};
}

std::string wide_seeds(std::uint64_t first_seed) {
  std::string table = markdown_head({"seed", "devices", "held by residual torque", "separating", "floating",
                                     "never touching", "over 10 mm deep"});
  const auto row = [&](const std::string& name, const wide_row& r) {
    table += markdown_row({name, written("%zu", r.count), written("%d", r.held), written("%d", r.separating),
                           written("%d", r.floating), written("%d", r.never), written("%d", r.deep)});
  };
  wide_row sum;
  for (std::uint64_t seed = first_seed; seed < first_seed + 10; ++seed) {
    const wide_row r = follow_all(tendons, seed, 300, belief::data_sheet, 1e-4);
    row(written("%llu", static_cast<unsigned long long>(seed)), r);
    sum.count += r.count;
    sum.held += r.held;
    sum.separating += r.separating;
    sum.floating += r.floating;
    sum.never += r.never;
    sum.deep += r.deep;
  }
  row("all", sum);
  return table;
}

std::string wide_table(const std::vector<wide_row>& rows) {
  std::string table = markdown_head({"device", "devices", "held by residual torque", "separating", "floating",
                                     "never touching", "over 10 mm deep", "of these: nothing is displayable",
                                     "brakes too weak", "median deviation [mm]"});
  for (const wide_row& r : rows)
    table += markdown_row({r.device, written("%zu", r.count), written("%d", r.held),
                           written("%d", r.separating), written("%d", r.floating), written("%d", r.never),
                           written("%d", r.deep), written("%d", r.deep_nothing), written("%d", r.deep_weak),
                           written("%.3f", 1e3 * r.median_std)});
  return table;
}

}  // namespace experiments
