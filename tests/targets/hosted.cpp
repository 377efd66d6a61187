// Output on a target with an operating system, where the headers for scenes and the readers of meshes
// compile, too.
#include "output.hpp"

#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/scene/files/obj.hpp>
#include <passive_haptics/scene/files/ply.hpp>
#include <passive_haptics/scene/files/stl.hpp>
#include <passive_haptics/scene/mesh/mesh_surface.hpp>

#include <cstdio>

void output::write(const char* text) { std::fputs(text, stdout); }
