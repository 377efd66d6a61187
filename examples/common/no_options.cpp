// Runs before the main of an example without options, which can thus be as short as in README. The linker
// calls it instead of main (--wrap=main).
#include <command_line.hpp>

extern "C" int __real_main();
extern "C" int __wrap_main(int argc, char** argv) {
  example::command_line line(EXAMPLE_NAME, "The whole program is examples/" EXAMPLE_FILE ".");
  line.parse(argc, argv);
  return __real_main();
}
