// Runs a log of a device's motion through a control law and writes what the brakes would have been told.
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

constexpr const char* help = R"(usage: 05_replay [OPTION VALUE]...

Reads a log of a device's motion, runs each line through a control law beside one virtual wall, and writes what the
brakes would have been told. Without options: a short log of the tendon device, made up here.

options
  --mechanism NAME     two_link, tendon_two_link (default), xy_table, five_bar, five_bar_4 or delta, with the
                       library's default dimensions
  --wall SHAPE         plane:POINT,NORMAL     wall behind POINT [m], NORMAL points to the free side
                       solid:CENTRE,RADIUS    round, free outside [m]
                       hollow:CENTRE,RADIUS   round, free inside [m]
                       coordinates x,y or x,y,z; default plane:0,0.225,0,-1 (3-D: plane:0,0,-0.15,0,0,1)
  --stiffness K        of the wall [N/m], default 1e7
  --law NAME           direct_control (default) or no_direct_control
  --limit T            torque limit of each brake [N m; N for a slide], default 1
  --dead-band W        rate under which a brake counts as at rest [rad/s; m/s for a slide], default 0.02
  --input FILE         the log; default: a short one made up here
  --output FILE        default replay.csv; written whole, or not at all
  --help               this text

columns of the log (comma-separated, this header first; SI units, base frame)
  t                    time [s], never decreasing
  q1 ...               joint positions [rad; m for a slide]
  qd1 ...              joint rates [rad/s; m/s for a slide]
  Fh_x Fh_y (Fh_z)     force of the hand on the handle [N]; 0 where there is no force sensor

columns of the output
  t                    time [s], as in the log
  power                class of the desired force by power: none, active, passive I, passive II
  display              how it is displayed: exact, approximate, none, empty cone
  gamma                angle between desired and displayed force [rad]
  alpha                scale factor of the law [1]
  Fd_x ...             desired force [N]
  Fc_x ...             displayed force before alpha and torque limits [N]
  capacity1 ...        what each brake may hold [N m; N for a slide], >= 0
  torque1 ...          what each brake is predicted to do [N m; N for a slide]
  status               ok, or why the brakes are released
)";

using options = std::map<std::string, std::string>;

options parse(int argc, char** argv) {
  options chosen{{"--mechanism", "tendon_two_link"},
                 {"--wall", ""},
                 {"--stiffness", "1e7"},
                 {"--law", "direct_control"},
                 {"--limit", "1"},
                 {"--dead-band", "0.02"},
                 {"--input", ""},
                 {"--output", "replay.csv"}};
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i];
    if (name == "--help" || name == "-h") {
      std::cout << help;
      std::exit(0);
    }
    if (!chosen.contains(name)) {
      std::string choices;
      for (const auto& [option, value] : chosen) choices += option + " ";
      throw std::invalid_argument("unknown option '" + name + "'; choices: " + choices + "--help");
    }
    if (i + 1 == argc) throw std::invalid_argument("a value is missing after '" + name + "'");
    chosen[name] = argv[i + 1];
  }
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
  brakes.torque_limit.setConstant(example::number("--limit", chosen.at("--limit")));
  brakes.rate_dead_band.setConstant(example::number("--dead-band", chosen.at("--dead-band")));
  const ph::wall wall(wall_of<M::task_dimension>(chosen.at("--wall")),
                      example::number("--stiffness", chosen.at("--stiffness")));

  example::output_file out(chosen.at("--output"));
  const auto start = std::chrono::steady_clock::now();
  auto told = start;
  const auto progress = [&](std::size_t lines) {
    const auto now = std::chrono::steady_clock::now();
    if (now - told < std::chrono::seconds(2)) return;
    told = now;
    std::fprintf(stderr, "%zu lines\n", lines);
  };
  const auto& law = chosen.at("--law");
  std::size_t lines = 0;
  if (law == "direct_control")
    lines = example::replay(in, out.stream(), M(), brakes, wall, ph::direct_control(), progress);
  else if (law == "no_direct_control")
    lines = example::replay(in, out.stream(), M(), brakes, wall, ph::no_direct_control(), progress);
  else throw std::invalid_argument("--law: '" + law + "', expected direct_control or no_direct_control");
  out.commit();
  std::cout << lines << " lines: " << std::filesystem::weakly_canonical(chosen.at("--output")).string()
            << "\n";
}

}  // namespace

int main(int argc, char** argv) try {
  const options chosen = parse(argc, argv);
  std::ifstream file;
  std::istringstream made_up;
  if (chosen.at("--input").empty()) made_up.str(made_up_log());
  else file.open(chosen.at("--input"), std::ios::binary);
  if (!chosen.at("--input").empty() && !file)
    throw std::runtime_error("cannot read '" + chosen.at("--input") + "'");
  std::istream& in = chosen.at("--input").empty() ? static_cast<std::istream&>(made_up) : file;

  const std::map<std::string, void (*)(const options&, std::istream&)> mechanisms{
      {"two_link", run<ph::two_link<double>>},      {"tendon_two_link", run<ph::tendon_two_link<double>>},
      {"xy_table", run<ph::xy_table<double>>},      {"five_bar", run<ph::five_bar<double>>},
      {"five_bar_4", run<ph::five_bar<double, 4>>}, {"delta", run<ph::delta<double>>}};
  const auto found = mechanisms.find(chosen.at("--mechanism"));
  if (found == mechanisms.end()) {
    std::string names;
    for (const auto& [name, function] : mechanisms) names += " " + name;
    throw std::invalid_argument("--mechanism: '" + chosen.at("--mechanism") + "', expected one of" + names);
  }
  found->second(chosen, in);
} catch (const std::invalid_argument& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 2;
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}
