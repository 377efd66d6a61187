// Before the main of an example that takes no options: it stays as short as README has it. The linker
// calls this one in its place (--wrap=main).
#include <command_line.hpp>

extern "C" int __real_main();
extern "C" int __wrap_main(int argc, char** argv) {
  example::command_line line(EXAMPLE_NAME, "All that it does is in examples/" EXAMPLE_FILE ".");
  line.parse(argc, argv);
  return __real_main();
}
