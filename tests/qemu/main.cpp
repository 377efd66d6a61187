// The first and only program of the guest: loads the modules, runs each check and switches the machine off.
#include "guest.hpp"

#include <fcntl.h>
#include <sys/mount.h>
#include <sys/reboot.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>

namespace {

void load(const char* file, const char* parameters) {
  const int module = open(file, O_RDONLY | O_CLOEXEC);
  if (syscall(SYS_finit_module, module, parameters, 0) != 0)
    std::printf("%s: %s\n", file, std::strerror(errno));
  close(module);
}

void prepare() {
  mkdir("/dev", 0755);
  mount("dev", "/dev", "devtmpfs", 0, "");
  const int console = open("/dev/console", O_RDWR);
  for (int standard = 0; standard < 3; ++standard) dup2(console, standard);
  if (console > 2) close(console);
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  load("/comedi.ko", "comedi_num_legacy_minors=1");
  load("/comedi_test.ko", "");
}

void run(const guest::check& check) {
  guest::outcome found;
  try {
    found = check.run();
  } catch (const std::exception& e) {
    found.error = e.what();
  }
  if (!found.error.empty()) std::printf("FAILED %s: %s\n", check.name, found.error.c_str());
  else if (found.figures.empty()) std::printf("ok %s\n", check.name);
  else std::printf("ok %s: %s\n", check.name, found.figures.c_str());
}

}  // namespace

int main() {
  prepare();
  for (const auto checks : {guest::opening_checks, guest::loopback_checks, guest::lost_device_checks,
                            guest::killed_program_checks, guest::loop_checks})
    for (const guest::check& check : checks()) run(check);
  std::printf("done\n");
  sync();
  reboot(RB_POWER_OFF);
}
