// Replay of a log: what it computes, what it says of a malformed log, and that memory does not grow with the
// log.
#include "../../../examples/common/replay.hpp"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <sstream>

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

const std::string header = "t,q1,q2,qd1,qd2,Fh_x,Fh_y\n";
const std::string good = "0.5,1.9,-1.2,0.1,0.2,0.5,2\n";

const ph::wall<example::any_wall<2>> wall{example::any_wall<2>(ph::half_space<2>({0, 0.2}, {0, -1}))};

std::string replay(std::istream& in) {
  std::ostringstream out;
  example::replay(in, out, device(), ph::brakes_of<device>(), wall, ph::direct_control());
  return out.str();
}

std::string message_for(const std::string& log) {
  std::istringstream in(log);
  try {
    replay(in);
  } catch (const example::log_error& error) {
    return error.what();
  }
  return "no message";
}

struct malformed {
  const char* what;
  std::string log;
  std::string message;
};

// A log that is made up as it is read.
class endless_log : public std::streambuf {
 public:
  explicit endless_log(std::size_t lines) : left_(lines), text_(header) { show(); }

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

// Takes everything and keeps nothing.
class nowhere : public std::streambuf {
 public:
  std::size_t bytes = 0;

 protected:
  std::streamsize xsputn(const char*, std::streamsize n) override {
    bytes += static_cast<std::size_t>(n);
    return n;
  }
  int_type overflow(int_type c) override { return ++bytes, traits_type::not_eof(c); }
};

long peak_memory() {  // [KiB]
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

}  // namespace

TEST(replay, tells_what_a_controller_tells) {
  std::istringstream in(header + good);
  std::istringstream lines(replay(in));
  std::string names, values;
  std::getline(lines, names);
  std::getline(lines, values);
  EXPECT_EQ(names,
            "t,power,display,gamma,alpha,Fd_x,Fd_y,Fc_x,Fc_y,capacity1,capacity2,torque1,torque2,status");

  ph::controller control{device(), ph::brakes_of<device>(), ph::scene(wall), ph::direct_control()};
  const auto r = control(ph::device_state<device>{0.5, {1.9, -1.2}, {0.1, 0.2}, {0.5, 2}});
  std::ostringstream expected;
  expected.precision(17);
  std::istringstream fields(values);
  const auto next = [&] {
    std::string field;
    std::getline(fields, field, ',');
    return field;
  };
  EXPECT_EQ(next(), "0.5");
  EXPECT_EQ(next(), to_string(r.power));
  EXPECT_EQ(next(), to_string(r.display));
  for (const double value :
       {r.approximation_angle(), r.alpha, r.desired_force[0], r.desired_force[1], r.control_force[0],
        r.control_force[1], r.capacity[0], r.capacity[1], r.torque[0], r.torque[1]}) {
    EXPECT_EQ(std::stod(next()), value);  // the shortest text reads back as the same number
  }
  EXPECT_EQ(next(), "ok");
}

TEST(replay, names_line_column_and_expectation_of_a_malformed_log) {
  const std::string number = ", expected a finite number for ";
  const malformed all[] = {
      {"nothing at all", "", "line 1: the log is empty, expected the header 't,q1,q2,qd1,qd2,Fh_x,Fh_y'"},
      {"no header", good, "line 1, column 1: column '0.5', expected a column 't'"},
      {"a header of another device", "t,q1,q2,q3,qd1,qd2,qd3\n",
       "line 1, column 4: column 'q3', expected a column 'qd1'"},
      {"a header that ends early", "t,q1,q2\n", "line 1, column 4: the header ends, expected a column 'qd1'"},
      {"a header with more", "t,q1,q2,qd1,qd2,Fh_x,Fh_y,Fh_z\n",
       "line 1, column 8: column 'Fh_z', expected no further column"},
      {"columns in another order", "q1,t,q2,qd1,qd2,Fh_x,Fh_y\n",
       "line 1, column 1: column 'q1', expected a column 't'"},
      {"a unit in the header", "t [s],q1,q2,qd1,qd2,Fh_x,Fh_y\n",
       "line 1, column 1: column 't [s]', expected a column 't'"},
      {"a line too short", header + good + "0.6,1,2,3,4,5\n",
       "line 3, column 7: the line ends, expected a number for 'Fh_y'"},
      {"a line too long", header + "0,1,2,3,4,5,6,7\n", "line 2, column 8: '7', expected 7 numbers"},
      {"an empty field", header + "0,1,,3,4,5,6\n", "line 2, column 3: an empty field" + number + "'q2'"},
      {"a blank field", header + "0,1,  ,3,4,5,6\n", "line 2, column 3: an empty field" + number + "'q2'"},
      {"a word", header + "0,1,two,3,4,5,6\n", "line 2, column 3: 'two'" + number + "'q2'"},
      {"a quoted number", header + "0,\"1\",2,3,4,5,6\n", "line 2, column 2: '\"1\"'" + number + "'q1'"},
      {"a number with a unit", header + "0,1 rad,2,3,4,5,6\n",
       "line 2, column 2: ' rad' after a number" + number + "'q1' alone, without a unit"},
      {"two numbers in a field", header + "0,1 2,3,4,5,6,7\n",
       "line 2, column 2: ' 2' after a number" + number + "'q1' alone, without a unit"},
      {"a decimal comma", header + "0;1,5;2;3;4;5;6\n",
       "line 2, column 1: '0;1', expected fields separated by commas"},
      {"tabs", header + "0\t1\t2\t3\t4\t5\t6\n",
       "line 2, column 1: '0\t1\t2\t3\t4\t5\t6', expected fields separated by commas"},
      {"not a number", header + "0,1,nan,3,4,5,6\n", "line 2, column 3: 'nan'" + number + "'q2'"},
      {"infinity", header + "0,1,2,-inf,4,5,6\n", "line 2, column 4: '-inf'" + number + "'qd1'"},
      {"a number out of range", header + "0,1,2,3,4,1e999,6\n",
       "line 2, column 6: '1e999' is out of range" + number + "'Fh_x'"},
      {"a hexadecimal number", header + "0,0x10,2,3,4,5,6\n",
       "line 2, column 2: 'x10' after a number" + number + "'q1' alone, without a unit"},
      {"two signs", header + "0,+-1,2,3,4,5,6\n", "line 2, column 2: '+-1'" + number + "'q1'"},
      {"a comment", header + "# calibration\n" + good, "line 2, column 1: '# calibration'" + number + "'t'"},
      {"time that runs backwards", header + good + "0.4,1,2,3,4,5,6\n",
       "line 3, column 1: time 0.4, expected no time before that of the line above"},
      {"a blank line in between", header + good + "\n" + good,
       "line 4: a blank line before this one, expected numbers in each line"},
      {"a zero byte", header + std::string("0,1,2\0,3", 8), "line 2: a zero byte, expected text"},
      {"an endless line", header + std::string(5000, '1'),
       "line 2: more than 4096 characters, expected a shorter line"},
      {"a line cut short at the end", header + good + "0.6,1,2",
       "line 3, column 4: the line ends, expected a number for 'qd1'"},
  };
  for (const auto& [what, log, message] : all) EXPECT_EQ(message_for(log), message) << what;
}

TEST(replay, takes_what_programs_write) {
  const auto lines = [](const std::string& log) {
    std::istringstream in(log);
    const std::string out = replay(in);
    return std::count(out.begin(), out.end(), '\n') - 1;
  };
  EXPECT_EQ(lines(header), 0);
  EXPECT_EQ(lines(header + good + good), 2);
  EXPECT_EQ(lines("\xEF\xBB\xBF" + header + good), 1);  // a byte order mark
  EXPECT_EQ(lines("t, q1, q2, qd1, qd2, Fh_x, Fh_y\r\n0, 1, 2, 3, 4, 5, 6\r\n"),
            1);                                                // blanks, and lines as of Windows
  EXPECT_EQ(lines(header + "0,1,2,3,4,5,6"), 1);               // no newline at the end
  EXPECT_EQ(lines(header + good + "\n\n"), 1);                 // blank lines at the end
  EXPECT_EQ(lines(header + "+0,1e0,.5,-3.,4,5,1e-320\n"), 1);  // all spellings of a number
}

TEST(replay, needs_no_more_memory_for_a_longer_log) {
  const auto run = [](std::size_t count) {
    endless_log source(count);
    nowhere sink;
    std::istream in(&source);
    std::ostream out(&sink);
    EXPECT_EQ(example::replay(in, out, device(), ph::brakes_of<device>(), wall, ph::direct_control()), count);
    EXPECT_GT(sink.bytes, 50 * count);
  };
  run(1000);
  const long before = peak_memory();
  run(address_sanitizer ? 30000 : 300000);
  const long allowed = address_sanitizer ? 16384 : 1024;  // there freed memory stays in quarantine
  EXPECT_LE(peak_memory() - before, allowed) << "KiB more for many times as many lines";
}
