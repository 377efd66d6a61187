#include <log/replay_program.hpp>

#include <command_line.hpp>
#include <number_list.hpp>
#include <output_file.hpp>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>

namespace example {
namespace {

replay_options parse(int argc, char** argv, const std::vector<std::string>& mechanisms, bool has_made_up) {
  replay_options chosen;
  chosen.mechanism = mechanisms.front();
  command_line line("replay",
                    "Reads a log (docs/guide/log.md), runs each line through a control law beside a virtual "
                    "wall, and writes\n"
                    "the commands to the brakes to replay.csv.");
  line.text("--input", chosen.input, "FILE",
            has_made_up ? "the log; without it a short one of the tendon device, made up here" : "the log");
  line.choice("--mechanism", chosen.mechanism, mechanisms, "whose log it is");
  line.texts("--parameter", chosen.parameters, "NAME=VALUE",
             "of the mechanism, as length_1=0.2; the others keep their defaults (docs/guide/parameters.md).\n"
             "Once for each");
  line.text("--wall", chosen.wall, "SHAPE",
            "plane:POINT,NORMAL    wall behind POINT [m], NORMAL points to the free side\n"
            "solid:CENTRE,RADIUS   round, free outside [m]\n"
            "hollow:CENTRE,RADIUS  round, free inside [m]\n"
            "coordinates x,y or x,y,z; default plane:0,0.225,0,-1 (in space plane:0,0,-0.15,0,0,1)");
  line.positive("--stiffness", chosen.stiffness, "of the wall [N/m]");
  line.choice("--law", chosen.law,
              {"direct_control", "saturated_direct_control", "velocity_direct_control", "no_direct_control"},
              "the control law");
  line.positive("--limit", chosen.limit, "torque limit of each brake [N m; N for a slide]");
  line.not_negative("--dead-band", chosen.dead_band,
                    "rate under which a brake counts as at rest [rad/s; m/s for a slide]");
  line.output(chosen.directory);
  line.parse(argc, argv);
  if (chosen.input.empty() && !has_made_up)
    throw std::invalid_argument("--input is missing, expected the name of a log");
  return chosen;
}

// Lines done, every two seconds.
std::function<void(std::size_t)> progress() {
  return [printed = std::chrono::steady_clock::now()](std::size_t lines) mutable {
    const auto now = std::chrono::steady_clock::now();
    if (now - printed < std::chrono::seconds(2)) return;
    printed = now;
    std::fprintf(stderr, "%zu lines\n", lines);
  };
}

void run(const replay_options& chosen, const replay_job& job, const std::string& made_up) {
  std::ifstream file;
  std::istringstream text(made_up);
  if (!chosen.input.empty()) {
    file.open(chosen.input, std::ios::binary);
    if (!file) throw std::runtime_error("cannot read '" + chosen.input + "'");
  }
  std::istream& in = chosen.input.empty() ? static_cast<std::istream&>(text) : file;
  log_reader log(in, chosen.input.empty() ? "the log that is made up here" : chosen.input);
  const std::filesystem::path path = chosen.directory / "replay.csv";
  output_file out(path);
  const replay_summary all = job(chosen, log, out.stream(), progress());
  out.commit();
  std::cout << all.lines << " lines, " << all.decided
            << " with a decision: " << std::filesystem::weakly_canonical(path).string() << "\n";
  if (all.compared > 0)
    std::cout << "capacities as in the log, to the last digit: " << all.same << " of " << all.compared
              << "\n";
}

}  // namespace

template <int D>
ph::wall<any_shape<D>> wall_of(const replay_options& options) {
  const std::string usual = D == 2 ? "plane:0,0.225,0,-1" : "plane:0,0,-0.15,0,0,1";
  const std::string text = options.wall.empty() ? usual : options.wall, kind = text.substr(0, text.find(':'));
  const bool plane = kind == "plane";
  if (!plane && kind != "solid" && kind != "hollow")
    throw std::invalid_argument("--wall: shape '" + kind + "', expected plane:, solid: or hollow:");
  const auto values = numbers("--wall", text.size() > kind.size() ? text.substr(kind.size() + 1) : "");
  const std::size_t wanted = plane ? 2 * D : D + 1;
  if (values.size() != wanted)
    throw std::invalid_argument("--wall: " + std::to_string(values.size()) + " numbers in '" + text +
                                "', expected " + std::to_string(wanted));
  const ph::point<D> first(values.data());
  const auto seen = [&](const auto& shape) { return ph::wall(any_shape<D>(shape), options.stiffness); };
  if (plane) return seen(ph::half_space<D>(first, ph::point<D>(values.data() + D)));
  return seen(ph::ball<D>(first, values.back(), kind == "solid" ? ph::filling::solid : ph::filling::hollow));
}
template ph::wall<any_shape<2>> wall_of<2>(const replay_options&);
template ph::wall<any_shape<3>> wall_of<3>(const replay_options&);

std::map<std::string, std::string> values_by_name(const std::vector<std::string>& texts) {
  std::map<std::string, std::string> all;
  for (const auto& text : texts) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
      throw std::invalid_argument("--parameter: '" + text + "', expected NAME=VALUE");
    all[text.substr(0, equals)] = text.substr(equals + 1);
  }
  return all;
}

double parameter_number(const std::string& name, const std::string& text) {
  return number("--parameter: " + name, text);
}

int replay_program(int argc, char** argv, const std::vector<std::pair<std::string, replay_job>>& mechanisms,
                   const std::string& made_up) try {
  std::vector<std::string> names;
  for (const auto& [name, job] : mechanisms) names.push_back(name);
  const replay_options chosen = parse(argc, argv, names, !made_up.empty());
  for (const auto& [name, job] : mechanisms)
    if (name == chosen.mechanism) run(chosen, job, made_up);
  return 0;
} catch (const std::invalid_argument& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 2;
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}

}  // namespace example
