// Prints what the engine computes: of each preset all values, "PRESET ID NUMBER ..."; then of
// each preset a closed loop of 21 000 cycles, "loop:PRESET ID NUMBER ..." of its last cycle and "loop:PRESET
// hash H", of the bits of all numbers of all cycles. tests/explorer/engine.mjs does the same with
// engine.wasm.
#include <device.hpp>
#include <presets.hpp>
#include <simulation.hpp>

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>

namespace {

constexpr int cycles = 21'000, cycles_of_a_frame = 20, frames_of_a_side = 40;
constexpr double reach = 0.01;  // of the pointer to two sides of the handle at the start [m]

void print(const std::string& name, const explorer::named_value& v, const double* numbers) {
  std::printf("%s %s", name.c_str(), v.id);
  for (int i = 0; i < v.size; ++i) std::printf(" %.17g", numbers[v.offset + i]);
  std::printf("\n");
}

// FNV-1a over the two halves of each number, but for the angle, which another libm rounds otherwise.
struct hash {
  std::uint32_t value = 2166136261u;

  void add(double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    if (x != x) bits = 0x7ff8000000000000u;
    for (const std::uint32_t half : {std::uint32_t(bits), std::uint32_t(bits >> 32)})
      value = (value ^ half) * 16777619u;
  }
};

void print_loop(const explorer::preset& p) {
  const std::string name = std::string("loop:") + p.id;
  explorer::device device = explorer::make_device(explorer::settings(p.settings));
  explorer::simulation simulation(device.parts().settings);
  explorer::value_table& row = simulation.row();
  device.evaluate();
  const explorer::place start(device.values()["x"]);
  hash all;
  for (int frame = 0; frame < cycles / cycles_of_a_frame; ++frame) {
    const double way = frame / frames_of_a_side % 2 == 0 ? reach : -reach;
    simulation.step(cycles_of_a_frame, start + explorer::place(way, way / 2, -way), frame % 100 < 90);
    for (int k = 0; k < cycles_of_a_frame; ++k)
      for (const explorer::named_value& v : row.names())
        if (std::string(v.id) != "gamma")
          for (int i = 0; i < v.size; ++i)
            all.add(simulation.rows()[std::size_t(k * row.size() + v.offset + i)]);
  }
  for (const explorer::named_value& v : row.names()) print(name, v, row.data());
  std::printf("%s hash %u\n", name.c_str(), all.value);
}

}  // namespace

int main() {
  for (const explorer::preset& p : explorer::presets) {
    explorer::device device = explorer::make_device(explorer::settings(p.settings));
    device.evaluate();
    for (const explorer::named_value& v : device.values().names()) print(p.id, v, device.values().data());
  }
  for (const explorer::preset& p : explorer::presets) print_loop(p);
}
