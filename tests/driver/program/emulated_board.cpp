// The driver and the firmware itself, on a microcontroller in QEMU (Arm MPS2, Cortex-M4): what its brakes
// have it says on a line of its own. Its line to the host goes through the test.
#include "program.hpp"

#include <firmware/host_board.hpp>

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <mutex>
#include <thread>

namespace emulated_board_tests {

using namespace program;
namespace serial = example::serial;

#ifdef PASSIVE_HAPTICS_QEMU_ARM
const std::string emulator = PASSIVE_HAPTICS_QEMU_ARM, image = PASSIVE_HAPTICS_MPS2_FIRMWARE;
#else
const std::string emulator, image;
#endif

using bytes = std::vector<std::uint8_t>;

// A socket of QEMU's, which waits for us. It keeps as little on its way as the kernel allows.
int connected_to(const fs::path& path) {
  const int s = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const int least = 1;
  setsockopt(s, SOL_SOCKET, SO_SNDBUF, &least, sizeof least);
  sockaddr_un there{};
  there.sun_family = AF_UNIX;
  path.string().copy(there.sun_path, sizeof there.sun_path - 1);
  const bool done =
      eventually([&] { return connect(s, reinterpret_cast<const sockaddr*>(&there), sizeof there) == 0; });
  return done ? s : (close(s), -1);
}

// What the brakes had, from when on by the board's clock [ms].
struct brake_report {
  std::uint32_t time = 0;
  std::array<std::uint16_t, 2> current{};  // [serial::current_unit]
};

// Between a pseudo-terminal and the sockets of the board.
class line_through_the_test {
 public:
  line_through_the_test(const fs::path& line, const fs::path& brakes)
      : line_(connected_to(line)), brakes_(connected_to(brakes)), life_([this] { live(); }) {}
  ~line_through_the_test() {
    ended_ = true;
    life_.join();
    close(line_);
    close(brakes_);
  }

  bool is_up() const { return line_ >= 0 && brakes_ >= 0; }
  std::string path() const { return host_.path(); }
  serial::hello hello() {
    const std::lock_guard hold(guard_);
    return hello_;
  }
  serial::sample sample() {
    const std::lock_guard hold(guard_);
    return sample_;
  }
  std::vector<brake_report> reports() {
    const std::lock_guard hold(guard_);
    return reports_;
  }

 private:
  void live() {
    std::array<std::uint8_t, 4096> buffer;
    const auto received = [&](int from) {
      const ssize_t n = recv(from, buffer.data(), buffer.size(), MSG_DONTWAIT);
      return bytes(buffer.begin(), buffer.begin() + std::max<ssize_t>(n, 0));
    };
    serial::decoder from_board, from_brakes;
    bytes down;
    while (!ended_) {
      usleep(300);
      const std::size_t n = host_.read(buffer);
      // What the board has not taken when more comes is lost, so nothing old waits; the last, a release, is
      // kept
      if (n > 0) down.assign(buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(n));
      const ssize_t taken = send(line_, down.data(), down.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
      if (taken < 0 && errno != EAGAIN) return;
      down.erase(down.begin(), down.begin() + std::max<ssize_t>(taken, 0));
      const bytes up = received(line_);
      if (!up.empty()) host_.write(up);
      const std::lock_guard hold(guard_);
      for (const std::uint8_t b : up)
        if (from_board.take(b) == serial::outcome::packet) {
          unpack(from_board.last(), hello_);
          unpack(from_board.last(), sample_);
        }
      for (const std::uint8_t b : received(brakes_)) {
        serial::currents m;
        if (from_brakes.take(b) == serial::outcome::packet && unpack(from_brakes.last(), m))
          reports_.push_back({from_brakes.last().sequence, {m.current[0], m.current[1]}});
      }
    }
  }

  firmware::pseudo_terminal host_;
  int line_, brakes_;
  std::atomic<bool> ended_ = false;
  std::mutex guard_;  // of what follows
  serial::hello hello_;
  serial::sample sample_;  // the latest
  std::vector<brake_report> reports_;
  std::thread life_;  // last: it uses all of the above
};

struct an_emulated_board : a_driver_at_a_terminal {
  std::unique_ptr<line_through_the_test> line;

  void SetUp() override {
    if (emulator.empty())
      GTEST_SKIP() << "no qemu-system-arm or no arm-none-eabi-g++; Debian's qemu-system-arm and "
                      "libstdc++-arm-none-eabi-newlib bring them";
    a_driver_at_a_terminal::SetUp();
    if (IsSkipped()) return;
    // Its time is ours: counted in instructions (-icount) it falls behind for good where bytes keep it busy
    words command{emulator, "-M", "mps2-an386", "-display", "none", "-nodefaults", "-kernel", image};
    for (const std::string name : {"line", "brakes"}) {
      command.insert(command.end(),
                     {"-chardev", "socket,id=" + name + ",path=" + name + ",server=on,wait=off", "-serial",
                      "chardev:" + name});
    }
    spawn(command, "emulator");
    line = std::make_unique<line_through_the_test>(directory / "line", directory / "brakes");
    ASSERT_TRUE(line->is_up()) << text_of(directory / "emulator.err");
  }

  // The shipped configuration, but for the sensor, and such times that no load on this machine is a fault.
  void drive() {
    std::string text = text_of(shipped + "/serial.toml");
    const auto put = [&](const std::string& old, const std::string& now) {
      ASSERT_NE(text.find(old), std::string::npos) << old;
      text.replace(text.find(old), old.size(), now);
    };
    put("type = \"velocity_direct_control\"", "type = \"no_direct_control\"");
    put("\"/dev/ttyACM0\"", "\"" + line->path() + "\"");
    put("open_timeout = 3", "open_timeout = 20");
    put("pose = ", "max_gap = 5\nduration = 0.1\npose = ");
    put("priority = 80\nlock_memory = true", "max_overruns = 1000000\nmax_sleep = 10");
    put("supervisor_priority = 81", "hold_over = 10\nsupervisor_timeout = 5");
    const auto sensor = text.find("[sensor]"), loop = text.find("[loop]");
    text.replace(sensor, loop - sensor, "[sensor]\ntype = \"none\"\n\n");
    file("c.toml", text);
    start({"--config", "c.toml", "--quiet"});
    ASSERT_TRUE(reaches("active")) << ended();
    ASSERT_TRUE(board_holds()) << ended();
  }

  bool board_holds() {
    return eventually([&] {
      for (const auto& one : line->reports())
        if (one.current[0] > 0 || one.current[1] > 0) return true;
      return false;
    });
  }
  bool board_is_free() {
    return eventually([&] {
      const auto all = line->reports();
      return !all.empty() && all.back().current == std::array<std::uint16_t, 2>{};
    });
  }
  void expect_within_the_limit() {
    for (const auto& r : line->reports())
      for (const std::uint16_t c : r.current) ASSERT_LE(c, line->hello().current_limit);
  }
};

TEST_F(an_emulated_board, is_homed_and_held_at_the_wall) {
  ASSERT_NO_FATAL_FAILURE(drive());
  std::size_t first = 0;
  ASSERT_TRUE(reaches("active", 0, &first));
  ASSERT_TRUE(eventually([&] { return line->reports().size() > 2000; }));
  const outcome o = interrupt();
  EXPECT_EQ(o.status, 0) << o.out << o.err;
  EXPECT_TRUE(board_is_free());
  const log_file all = log();
  ASSERT_TRUE(all.is_whole());
  // Homed while the hand rested
  EXPECT_NEAR(all.number(first, "q1"), 1.8812, 1e-3);
  EXPECT_NEAR(all.number(first, "q2"), -1.3055, 1e-3);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all.number(i, "Fd_x") != 0 || all.number(i, "Fd_y") != 0) continue;
    ASSERT_EQ(all.number(i, "current1") + all.number(i, "current2"), 0) << "no current without a wall: " << i;
  }
  expect_within_the_limit();
}

TEST_F(an_emulated_board, lets_go_in_its_stated_time_when_the_host_is_killed) {
  ASSERT_NO_FATAL_FAILURE(drive());
  const pid_t guard = supervisor();
  ASSERT_GT(guard, 0);
  // Stopped first, or one would release before the other is dead
  for (const pid_t one : {guard, pid}) send(SIGSTOP, one);
  for (const pid_t one : {guard, pid}) send(SIGKILL, one);
  end();
  ASSERT_TRUE(eventually([&] { return line->sample().state == serial::sample::tripped; }));
  ASSERT_TRUE(board_is_free());
  const auto all = line->reports();
  ASSERT_GE(all.size(), 2u);
  const std::uint32_t silent = all.back().time - all[all.size() - 2].time;
  const serial::hello h = line->hello();
  ASSERT_GT(h.watchdog, 0) << "the board told its host";
  std::printf("the board let go %u ms after the last currents; stated: %u to %u\n", silent, h.watchdog,
              h.watchdog + h.period / 1000u);
  EXPECT_GE(silent, h.watchdog);
  EXPECT_LE(silent, h.watchdog + h.period / 1000u);
}

}  // namespace emulated_board_tests
