// slow
// Replay of a log: what it computes, that its own output replays to the last digit, and that memory does not
// grow with the log.
#include <log/decision.hpp>
#include <log/replay.hpp>

#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/wall_following.hpp>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <sys/resource.h>

#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <sstream>
#include <utility>

namespace ph = passive_haptics;
using device = ph::tendon_two_link<double>;

#if defined(__SANITIZE_ADDRESS__)  // g++
constexpr bool address_sanitizer = true;
#elif defined(__has_feature)  // clang++
constexpr bool address_sanitizer = __has_feature(address_sanitizer);
#else
constexpr bool address_sanitizer = false;
#endif

namespace {

const std::string log_header = "t,q1,q2,qd1,qd2,Fh_x,Fh_y\n";
const std::string good = "0.5,1.9,-1.2,0.1,0.2,0.5,2\n";
const ph::half_space<2> surface({0, 0.2}, {0, -1});

// A controller behind runtime/.
template <class Law>
std::unique_ptr<ph::runtime::any_controller> controller_at(const ph::half_space<2>& wall) {
  using namespace ph::runtime;
  return make_controller<Law>(device(), {brake_numbers(2), any_scene<2>(ph::scene(ph::wall(wall))),
                                         any_parameters(law_parameters<Law>())});
}

// The law of the paper beside a wall, or a law that needs no force.
example::replay_summary replay(std::istream& in, std::ostream& out, bool needs_force = true) {
  const auto control = needs_force ? controller_at<ph::direct_control>(surface)
                                   : controller_at<ph::no_direct_control>(surface);
  example::log_reader log(in, "log.csv");
  return example::replay(log, out, *control);
}
std::string replay(const std::string& log, bool needs_force = true) {
  std::istringstream in(log);
  std::ostringstream out;
  replay(in, out, needs_force);
  return out.str();
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> all;
  for (std::string line; std::getline(in, line);) all.push_back(line);
  return all;
}

// A log that is made up as it is read.
class endless_log : public std::streambuf {
 public:
  explicit endless_log(std::size_t lines) : left_(lines), text_(log_header) { show(); }

 protected:
  int_type underflow() override {
    if (left_ == 0) return traits_type::eof();
    --left_;
    text_ = good;
    show();
    return traits_type::to_int_type(text_[0]);
  }

 private:
  void show() { setg(text_.data(), text_.data(), text_.data() + text_.size()); }
  std::size_t left_;
  std::string text_;
};

long peak_memory() {  // [KiB]
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

}  // namespace

// What a controller decides is compared below, in a log of a simulation.
TEST(replay, writes_motion_and_decision_with_units) {
  const auto lines = lines_of(replay(log_header + good));
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0], "# passive_haptics log 1");
  EXPECT_EQ(lines[1], "# units: s,rad,rad,rad/s,rad/s,N,N,,,,rad,1,N,N,N,N,N m,N m,N m,N m");
  EXPECT_EQ(lines[2],
            "t,q1,q2,qd1,qd2,Fh_x,Fh_y,status,power,display,gamma,alpha,Fd_x,Fd_y,Fc_x,Fc_y,capacity1,"
            "capacity2,torque1,torque2");
}

TEST(replay, decides_nothing_where_a_number_is_missing) {
  const auto lines = lines_of(replay(log_header + "0,,,,,,\n0.1,1.9,-1.2,0.1,0.2,,\n" + good));
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_EQ(lines[3], "0,,,,,,,,,,,,,,,,,,,");
  EXPECT_EQ(lines[4], "0.1,1.9,-1.2,0.1,0.2,,,,,,,,,,,,,,,");
  EXPECT_EQ(lines[5].rfind("0.5,1.9,-1.2,0.1,0.2,0.5,2,ok,", 0), 0U);
}

TEST(replay, does_without_a_force_where_none_is_needed) {
  const auto missing = lines_of(replay(log_header + "0,1.9,-1.2,0.1,0.2,,\n", false));
  const auto none = lines_of(replay("t,q1,q2,qd1,qd2\n0,1.9,-1.2,0.1,0.2\n", false));
  const auto zero = lines_of(replay(log_header + "0,1.9,-1.2,0.1,0.2,0,0\n", false));
  const std::string decision = zero.back().substr(zero.back().find("ok"));
  EXPECT_EQ(missing.back(), "0,1.9,-1.2,0.1,0.2,,," + decision);
  EXPECT_EQ(none.back(), "0,1.9,-1.2,0.1,0.2,,," + decision);
  EXPECT_THROW(replay("t,q1,q2,qd1,qd2\n"), example::log_error);
}

TEST(replay, writes_the_units_that_it_reads) {
  const auto lines = lines_of(replay("# units: s,m,m,m/s,m/s,N,N\n" + log_header + good));
  EXPECT_EQ(lines[1], "# units: s,m,m,m/s,m/s,N,N,,,,rad,1,N,N,N,N,N,N,N,N");
}

// What is logged, replayed and replayed again is the same, to the last digit: of a run that tares first, and
// that is rearmed three times, once to be released in the same cycle again.
TEST(replay, of_a_simulation_makes_the_same_decisions) {
  const std::size_t begin = 5, first_release = 100, second_release = 300;
  const std::map<std::size_t, std::pair<const char*, const char*>> states{
      {0, {"ready", ""}},
      {begin, {"active", ""}},
      {first_release, {"released", "cycle late"}},
      {200, {"active", ""}},
      {second_release, {"released", "cycle late"}},
      {400, {"released", "device lost"}},
      {500, {"degraded", ""}}};
  const device arm;
  const auto q = arm.inverse({0.045, 0.221}, ph::elbow::left).q;
  const ph::half_space<2> wall({0, 0.225}, {0, -1});
  ph::controller control(arm, ph::brakes_of<device>(), ph::scene(ph::wall(wall)),
                         ph::velocity_direct_control());
  ph::following_hand<double, 2> hand({1, 0}, {0.045, 0.221}, {});
  ph::simulated_device plant(arm, ph::brakes_of<device>(), hand.parameters().mass, q);
  plant.set_motion(q, arm.jacobian(q).partialPivLu().solve(ph::vector<double, 2>(0.05, 0.1)));
  example::log_row row;
  std::string log;
  std::size_t count = 0;
  const auto logged = [&](const ph::device_state<device>& state) {
    const std::size_t line = count++;
    const bool runs = line >= begin;
    if (line > begin && line != first_release && line != second_release && states.contains(line))
      control.reset();
    const auto decision = runs ? control(state) : ph::step_result<device>();
    row.start();
    put_motion(row, {}, state);
    put_decision(row, {}, decision, runs);
    const auto& [name, reason] = std::prev(states.upper_bound(line))->second;
    row.put("state", name);
    row.put("reason", reason);
    if (log.empty()) log = row.header();
    log += row.csv();
    return decision;
  };
  ph::follow_wall(plant, logged, wall, hand, {.max_duration = 1});

  const auto replayed = [&](const std::string& text, example::replay_summary& all) {
    const auto again = controller_at<ph::velocity_direct_control>(wall);
    std::istringstream in(text);
    std::ostringstream out;
    example::log_reader reader(in, "log.csv");
    all = example::replay(reader, out, *again);
    return out.str();
  };
  example::replay_summary first, second;
  const std::string once = replayed(log, first);
  EXPECT_EQ(once, log);
  EXPECT_EQ(replayed(once, second), log);
  EXPECT_GE(first.lines, 900U);
  EXPECT_EQ(first.lines, count);
  EXPECT_EQ(first.decided, count - begin);
  EXPECT_EQ(first.compared, first.decided);
  EXPECT_EQ(first.same, first.decided);
}

TEST(replay, counts_the_capacities_that_differ) {
  std::istringstream in("t,q1,q2,qd1,qd2,Fh_x,Fh_y,capacity1,capacity2\n0,1.9,-1.2,0.1,0.2,0.5,2,9,9\n" +
                        std::string("0,1.9,-1.2,0.1,0.2,0.5,2,,\n"));
  std::ostringstream out;
  const auto all = replay(in, out);
  EXPECT_EQ(all.decided, 2U);
  EXPECT_EQ(all.compared, 1U);
  EXPECT_EQ(all.same, 0U);
}

TEST(replay, needs_no_more_memory_for_a_longer_log) {
  const auto run = [](std::size_t count) {
    endless_log source(count);
    std::istream in(&source);
    std::ofstream out("/dev/null");
    EXPECT_EQ(replay(in, out).lines, count);
  };
  run(1000);
  const long before = peak_memory();
  run(address_sanitizer ? 30000 : 100000);
  const long allowed = address_sanitizer ? 16384 : 1024;  // there freed memory stays in quarantine
  EXPECT_LE(peak_memory() - before, allowed) << "KiB more for many times as many lines";
}
