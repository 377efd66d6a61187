// Output on a target with an operating system.
#include "output.hpp"

#include <cstdio>

void output::write(const char* text) { std::fputs(text, stdout); }
