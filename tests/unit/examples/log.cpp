// The format of a log: what is written reads back, what is wrong is named with file, line and column.
#include <log/device_name.hpp>
#include <log/known_columns.hpp>
#include <log/live_stream.hpp>
#include <log/log_columns.hpp>
#include <log/log_reader.hpp>
#include <log/log_row.hpp>

#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>

namespace {

using example::log_reader;
using example::log_row;

const std::string header = "t,q1,note\n", good = "0.5,1,x\n";

std::string message_for(const std::string& log) {
  std::istringstream in(log);
  try {
    log_reader reader(in, "a.csv");
    const std::size_t q = reader.column("q1", {"rad", "m"});
    while (reader.next()) reader.number(q);
  } catch (const example::log_error& error) {
    return error.what();
  }
  return "no message";
}

std::size_t lines_in(const std::string& log) {
  std::istringstream in(log);
  log_reader reader(in, "a.csv");
  std::size_t count = 0;
  while (reader.next()) {
    reader.number(reader.column("q1", {"rad"}));
    ++count;
  }
  return count;
}

log_row example_row() {
  log_row row;
  row.start();
  row.put("t", "s", 0.1);
  row.put("q", "rad", std::array{1.5, std::nan("")});
  row.put_axes("Fh", "N", std::array{-2e-7, HUGE_VAL});
  row.put("cycle", "1", std::int64_t{1'000'000});
  row.put("state", "released: \"late\", twice");
  row.put("reason", "");
  return row;
}

// Datagrams to a port of this machine.
class listener {
 public:
  listener() {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    const timeval patience{10, 0};
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    EXPECT_EQ(bind(socket_, reinterpret_cast<const sockaddr*>(&address), size), 0);
    EXPECT_EQ(getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size), 0);
    port = ntohs(address.sin_port);
  }
  ~listener() { close(socket_); }

  std::string next() {
    std::array<char, 4096> bytes;
    const ssize_t n = recv(socket_, bytes.data(), bytes.size(), 0);
    return n < 0 ? "nothing came" : std::string(bytes.data(), static_cast<std::size_t>(n));
  }
  int port = 0;

 private:
  int socket_ = socket(AF_INET, SOCK_DGRAM, 0);
};

const std::string example_json =
    R"({"t":0.1,"q1":1.5,"Fh_x":-2e-07,"cycle":1000000,"state":"released: \"late\", twice"})";

}  // namespace

TEST(log_row, is_a_line_of_csv_below_version_units_and_names) {
  log_row row = example_row();
  EXPECT_EQ(row.header(),
            "# passive_haptics log 1\n# units: s,rad,rad,N,N,1,,\nt,q1,q2,Fh_x,Fh_y,cycle,state,reason\n");
  EXPECT_EQ(row.csv(), "0.1,1.5,,-2e-07,,1000000,\"released: \"\"late\"\", twice\",\n");
  row.start();
  row.put("t", "s", 0.2);
  EXPECT_EQ(row.csv(), "0.2\n");
}

TEST(log_row, is_an_object_of_json_without_the_empty_cells) {
  EXPECT_EQ(example_row().json(), example_json);
  log_row row;
  row.start();
  row.put("t", "s", NAN);
  EXPECT_EQ(row.json(), "{}");
}

// Any finite number, to its last bit; seed 20040627.
TEST(log_row, reads_back_as_the_same_numbers) {
  std::mt19937_64 random(20040627);
  using limits = std::numeric_limits<double>;
  std::vector<double> numbers{
      0,   -0.0,    limits::min(), limits::max(), limits::lowest(), limits::denorm_min(),
      0.1, 1.0 / 3, 5145.8,        1e22};
  while (numbers.size() < 2'000)
    if (const double x = std::bit_cast<double>(random()); std::isfinite(x)) numbers.push_back(x);
  log_row row;
  std::string log;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    row.start();
    row.put("t", "s", static_cast<double>(i));
    row.put("q1", "rad", numbers[i]);
    if (i == 0) log = row.header();
    log += row.csv();
  }
  std::istringstream in(log);
  log_reader reader(in, "a.csv");
  const std::size_t q = reader.column("q1", {"rad"});
  for (const double x : numbers) {
    ASSERT_TRUE(reader.next());
    ASSERT_EQ(std::bit_cast<std::uint64_t>(reader.number(q)), std::bit_cast<std::uint64_t>(x)) << x;
  }
  EXPECT_FALSE(reader.next());
}

TEST(device_name, is_that_of_the_log_until_and_after_it_is_whole) {
  EXPECT_EQ(example::device_name("a.b/c.csv"), "a.b/c.device.toml");
  EXPECT_EQ(example::device_name("a.b/c.csv.part"), "a.b/c.device.toml.part");
  EXPECT_EQ(example::device_name("a.b/c"), "a.b/c.device.toml");
}

TEST(log_reader, finds_columns_by_name_beside_others) {
  std::istringstream in(
      "# passive_haptics log 1\n# made by hand\n# units: ,rad,s\nnote,q1,t\n\"a, b\",1,2\n,,3\n");
  log_reader reader(in, "a.csv");
  const std::size_t q = reader.column("q1", {"m", "rad"});
  EXPECT_EQ(q, 1U);
  EXPECT_EQ(reader.unit(q), "rad");
  EXPECT_FALSE(reader.find("q2"));
  ASSERT_TRUE(reader.next());
  EXPECT_EQ(reader.number(q), 1);
  ASSERT_TRUE(reader.next());
  EXPECT_TRUE(std::isnan(reader.number(q))) << "an empty cell";
  EXPECT_FALSE(reader.next());
}

TEST(log_reader, names_file_line_column_and_expectation_of_what_is_wrong) {
  const std::string number = ": expected a finite number for 'q1'";
  const std::string zero =
      "a zero byte or Ctrl-Z: expected text; lines may be lost here: if none is, remove such bytes";
  struct malformed {
    const char* what;
    std::string log, message;
  };
  const malformed all[] = {
      {"nothing at all", "", "line 1: the log is empty: expected a line of names, t,q1,..."},
      {"no header", good,
       "line 1: no column 't': expected one among '0.5,1,x', separated by commas, semicolons or tabs"},
      {"no such column", "t,q2\n", "line 1: no column 'q1': expected one among 't,q2'"},
      {"a column twice", "t,q1,q1\n", "line 1, column 3: a second 'q1': expected each name once"},
      {"another unit", "# units: s,deg,\n" + header,
       "line 2, column 2: 'q1' in 'deg': expected it in rad or m"},
      {"time in another unit", "# units: ms,rad,\n" + header,
       "line 2, column 1: 't' in 'ms': expected it in s"},
      {"too few units", "# units: s,rad\n" + header,
       "line 2: 3 names and the units ' s,rad': expected a unit for each name, separated as the names are; "
       "write them so, or remove the line of units"},
      {"a log to come", "# passive_haptics log 2\n" + header, "line 1: version 2: expected version 1"},
      {"a line too short", header + "0.6,1\n", "line 2, column 3: the line ends: expected a cell for 'note'"},
      {"a line too long", header + "0,1,2,3\n", "line 2, column 4: '3': expected 3 cells"},
      {"no time", header + " ,1,2\n",
       "line 2, column 1: no time: expected no time before that of the line above"},
      {"a word", header + "0,two,3\n", "line 2, column 2: 'two'" + number},
      {"two separators", header + "0,1;5,2\n",
       "line 2, column 2: '1;5': expected cells separated as the names are"},
      {"a decimal comma", "t;q1\n0;1,5\n",
       "line 2, column 2: '1,5'" + number + "; write a decimal point instead of the comma"},
      {"a number out of range", header + "0,1e999,2\n", "line 2, column 2: '1e999' is out of range" + number},
      {"time that runs backwards", header + good + "0.4,1,2\n",
       "line 3, column 1: time 0.4: expected no time before that of the line above"},
      {"a blank line in between", header + good + "\n" + good,
       "line 4: a blank line before this one: expected numbers in each line"},
      {"a last line that may be cut off", "# passive_haptics log 1\nt,q1\n0,1\n1,1.5",
       "line 4: the line has no newline: expected one at the end of each line; the log was cut off: "
       "remove this line, or end it"},
      {"a zero byte", header + std::string("0,1,2\0,3", 8), "line 2: " + zero},
      {"control characters", header + "0,1\x1b[2J\t,3\n",
       "line 2, column 2: '?[2J?' after a number" + number + " without a unit; write units into the header"},
      {"an open quote", header + "0,1,\"x\n0.1,1,2\n", "no message"},  // of a column that nobody reads
  };
  for (const auto& [what, log, message] : all)
    EXPECT_EQ(message_for(log), (message == "no message" ? "" : "a.csv, ") + message) << what;
}

TEST(log_reader, takes_the_ends_of_lines_and_files_that_programs_write) {
  EXPECT_EQ(lines_in(header), 0U);
  for (const std::string& log :
       {header + "0,1,2", std::string("t, q1, note\r\n0, 1, 2\r\n"), header + good + "\n\n",
        std::string("t,q1\r0,1\r"), header + good + "\x1a", header + good + std::string(1, '\0')})
    EXPECT_EQ(lines_in(log), 1U) << log;
}

TEST(log_reader, takes_what_other_programs_write) {
  const struct {
    const char* program;
    std::string log;
  } all[] = {
      {"R, write.csv", "\"\",\"t\",\"q1\"\n\"1\",0,1.5\n\"2\",1,2.5\n"},
      {"Python, csv.QUOTE_ALL, a byte order mark",
       "\xEF\xBB\xBF\"t\",\"q1\"\n\"0\",\"1.5\"\n\"1\",\"2.5\"\n"},
      {"NumPy, savetxt with a header",
       "# t,q1\n0.000000000000000000e+00,1.500000000000000000e+00\n1e+00,2.5e+00\n"},
      {"pandas, without a name of its index", ",t,q1\n0,0,1.5\n1,1,2.5\n"},
      {"a spreadsheet", "sep=;\r\nt;q1\r\n0;1.5\r\n1;2.5\r\n"},
      {"a table of tabs", "t\tq1\tnote\n0\t1.5\ta; b, c\n1\t2.5\t\n"},
      {"a remark that names columns, then names", "# q1 over t, t\nt,q1\n0,1.5\n1,2.5\n"},
  };
  for (const auto& [program, log] : all) {
    std::istringstream in(log);
    log_reader reader(in, "a.csv");
    const std::size_t t = reader.column("t", {"s"}), q = reader.column("q1", {"rad"});
    for (const double expected : {0.0, 1.0}) {
      ASSERT_TRUE(reader.next()) << program;
      EXPECT_EQ(reader.number(t), expected) << program;
      EXPECT_EQ(reader.number(q), expected + 1.5) << program;
    }
    EXPECT_FALSE(reader.next()) << program;
  }
  EXPECT_EQ(lines_in("# t,q1\n"), 0U);
}

TEST(live_stream, sends_each_row_as_json_to_a_port_of_this_machine) {
  listener there;
  example::live_stream stream;
  ASSERT_EQ(stream.open(there.port), "");
  log_row row = example_row();
  stream.send(row);
  EXPECT_EQ(there.next(), example_json);
}

TEST(live_stream, sends_nothing_unless_asked_and_needs_no_listener) {
  example::live_stream off, alone;
  log_row row = example_row();
  EXPECT_EQ(off.open(0), "");
  off.send(row);
  {
    listener gone;
    ASSERT_EQ(alone.open(gone.port), "");
  }
  for (int i = 0; i < 10; ++i) alone.send(row);
}

TEST(paced_stream, sends_all_that_it_was_given_before_it_ends) {
  listener there;
  log_row row;
  {
    example::paced_stream stream(there.port);
    for (const double t : {0.0, 0.01, 0.02}) {
      row.start();
      row.put("t", "s", t);
      stream.send(t, row);
    }
  }
  for (const char* expected : {R"({"t":0})", R"({"t":0.01})", R"({"t":0.02})"})
    EXPECT_EQ(there.next(), expected);
  example::paced_stream off(0);
  off.send(1000, row);
}

namespace {

std::vector<example::log_column> columns_in(const std::string& log) {
  std::istringstream in(log);
  log_reader reader(in, "a.csv");
  return example::columns_of(reader);
}

}  // namespace

TEST(log_columns, are_numbers_or_words_by_their_units) {
  const auto all = columns_in("# units: s,,1\nt,note,n\n0,\"a \"\"b\"\", c\",\n1,2,3\n");
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[1].words, (std::vector<std::string>{"a \"b\", c", "2"}));
  EXPECT_TRUE(std::isnan(all[2].numbers[0]));
  EXPECT_EQ(all[2].numbers[1], 3);
  EXPECT_TRUE(all[2].words.empty());
}

TEST(log_columns, of_a_log_without_units_are_those_of_the_library_or_what_their_cells_are) {
  const auto all = columns_in("t,q1,status,mine,yours\n0,,1,2,3\n1,5,ok,4,x\n");
  const std::vector<std::string> units{"s", "rad", "", "1", ""};
  for (std::size_t i = 0; i < units.size(); ++i) EXPECT_EQ(all[i].unit, units[i]) << all[i].name;
  EXPECT_EQ(all[3].numbers, (std::vector<double>{2, 4}));
  EXPECT_EQ(all[4].words, (std::vector<std::string>{"3", "x"}));
  EXPECT_THROW(columns_in("t,q1\n0,x\n"), example::log_error);
  EXPECT_THROW(columns_in("# units: s,deg\nt,q1\n0,1\n"), example::log_error);
}

TEST(log_columns, are_known_by_names_with_their_parts) {
  for (const char* name : {"t", "q1", "qd12", "Fh_z", "true_Fh_x", "brake_torque2", "held_over"})
    EXPECT_NE(example::find_known(name), nullptr) << name;
  for (const char* name : {"", "t1", "q", "q0", "q01", "qd_x", "Fh_w", "Fh1", "mine"})
    EXPECT_EQ(example::find_known(name), nullptr) << name;
}
