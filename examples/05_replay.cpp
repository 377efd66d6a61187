// Runs a log of a device's motion through a control law and writes what the brakes would have been told.
#include <command_line.hpp>
#include <number_list.hpp>
#include <output_file.hpp>
#include <replay.hpp>

#include <Eigen/LU>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>

namespace ph = passive_haptics;

namespace {

struct options {
  std::string mechanism = "tendon_two_link", wall, law = "direct_control", input;
  double stiffness = 1e7, limit = 1, dead_band = 0.02;
  std::filesystem::path directory = ".";
};

options parse(int argc, char** argv) {
  options chosen;
  example::command_line line(
      "replay",
      "Reads a log of a device's motion, runs each line through a control law beside one virtual "
      "wall, and writes\nwhat the brakes would have been told to replay.csv. Without options: a "
      "short log of the tendon device, made up here.");
  line.choice("--mechanism", chosen.mechanism,
              {"two_link", "tendon_two_link", "xy_table", "five_bar", "five_bar_4", "delta"},
              "with the library's default dimensions");
  line.text("--wall", chosen.wall, "SHAPE",
            "plane:POINT,NORMAL    wall behind POINT [m], NORMAL points to the free side\n"
            "solid:CENTRE,RADIUS   round, free outside [m]\n"
            "hollow:CENTRE,RADIUS  round, free inside [m]\n"
            "coordinates x,y or x,y,z; default plane:0,0.225,0,-1 (3-D: plane:0,0,-0.15,0,0,1)");
  line.positive("--stiffness", chosen.stiffness, "of the wall [N/m]");
  line.choice("--law", chosen.law, {"direct_control", "no_direct_control"}, "the control law");
  line.positive("--limit", chosen.limit, "torque limit of each brake [N m; N for a slide]");
  line.not_negative("--dead-band", chosen.dead_band,
                    "rate under which a brake counts as at rest [rad/s; m/s for a slide]");
  line.text("--input", chosen.input, "FILE", "the log; without it a short one, made up here");
  line.output(chosen.directory);
  line.parse(argc, argv);
  return chosen;
}

template <int D>
example::any_wall<D> wall_of(std::string text) {
  if (text.empty()) text = D == 2 ? "plane:0,0.225,0,-1" : "plane:0,0,-0.15,0,0,1";
  const std::string kind = text.substr(0, text.find(':'));
  const bool plane = kind == "plane";
  if (!plane && kind != "solid" && kind != "hollow") {
    throw std::invalid_argument("--wall: shape '" + kind + "', expected plane:, solid: or hollow:");
  }
  const auto values =
      example::numbers("--wall", text.size() > kind.size() ? text.substr(kind.size() + 1) : "");
  const std::size_t wanted = plane ? 2 * D : D + 1;
  if (values.size() != wanted) {
    throw std::invalid_argument("--wall: " + std::to_string(values.size()) + " numbers in '" + text +
                                "', expected " + std::to_string(wanted));
  }
  ph::point<D> first;
  for (int i = 0; i < D; ++i) first[i] = values[static_cast<std::size_t>(i)];
  if (!plane) {
    return example::any_wall<D>(
        ph::ball<D>(first, values.back(), kind == "solid" ? ph::filling::solid : ph::filling::hollow));
  }
  ph::point<D> normal;
  for (int i = 0; i < D; ++i) normal[i] = values[static_cast<std::size_t>(D + i)];
  return example::any_wall<D>(ph::half_space<D>(first, normal));
}

// Half a second along the wall and a little in and out of it.
std::string made_up_log() {
  const ph::tendon_two_link<double> arm;
  std::ostringstream log;
  log.precision(17);
  log << "t,q1,q2,qd1,qd2,Fh_x,Fh_y\n";
  for (int k = 0; k < 500; ++k) {
    const double t = 1e-3 * k, speed = 0.1, depth = 2e-4 * std::sin(20 * t);
    const auto q = arm.inverse({0.06 + speed * t, 0.225 + depth}, ph::elbow::left).q;
    const ph::vector<double, 2> qd =
        arm.jacobian(q).partialPivLu().solve(ph::vector<double, 2>(speed, 4e-3 * std::cos(20 * t)));
    log << t << "," << q[0] << "," << q[1] << "," << qd[0] << "," << qd[1] << ",0.5,2\n";
  }
  return log.str();
}

template <class M>
void run(const options& chosen, std::istream& in) {
  ph::brakes_of<M> brakes;
  brakes.torque_limit.setConstant(chosen.limit);
  brakes.rate_dead_band.setConstant(chosen.dead_band);
  const ph::wall wall(wall_of<M::task_dimension>(chosen.wall), chosen.stiffness);

  const auto path = chosen.directory / "replay.csv";
  example::output_file out(path);
  const auto start = std::chrono::steady_clock::now();
  auto told = start;
  const auto progress = [&](std::size_t lines) {
    const auto now = std::chrono::steady_clock::now();
    if (now - told < std::chrono::seconds(2)) return;
    told = now;
    std::fprintf(stderr, "%zu lines\n", lines);
  };
  const auto& law = chosen.law;
  std::size_t lines = 0;
  if (law == "direct_control")
    lines = example::replay(in, out.stream(), M(), brakes, wall, ph::direct_control(), progress);
  else if (law == "no_direct_control")
    lines = example::replay(in, out.stream(), M(), brakes, wall, ph::no_direct_control(), progress);
  else throw std::invalid_argument("--law: '" + law + "', expected direct_control or no_direct_control");
  out.commit();
  std::cout << lines << " lines: " << std::filesystem::weakly_canonical(path).string() << "\n";
}

}  // namespace

int main(int argc, char** argv) try {
  const options chosen = parse(argc, argv);
  std::ifstream file;
  std::istringstream made_up;
  if (chosen.input.empty()) made_up.str(made_up_log());
  else file.open(chosen.input, std::ios::binary);
  if (!chosen.input.empty() && !file) throw std::runtime_error("cannot read '" + chosen.input + "'");
  std::istream& in = chosen.input.empty() ? static_cast<std::istream&>(made_up) : file;

  const std::map<std::string, void (*)(const options&, std::istream&)> mechanisms{
      {"two_link", run<ph::two_link<double>>},      {"tendon_two_link", run<ph::tendon_two_link<double>>},
      {"xy_table", run<ph::xy_table<double>>},      {"five_bar", run<ph::five_bar<double>>},
      {"five_bar_4", run<ph::five_bar<double, 4>>}, {"delta", run<ph::delta<double>>}};
  const auto found = mechanisms.find(chosen.mechanism);
  if (found == mechanisms.end()) {
    std::string names;
    for (const auto& [name, function] : mechanisms) names += " " + name;
    throw std::invalid_argument("--mechanism: '" + chosen.mechanism + "', expected one of" + names);
  }
  found->second(chosen, in);
} catch (const std::invalid_argument& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 2;
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}
