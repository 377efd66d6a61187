// Chains of URDFs in a device file: which mechanism of the catalogue they become, and its parameters.
#include <catalogue/entries.hpp>
#include <catalogue/mechanisms.hpp>

#include <passive_haptics/runtime/device_file/definitions.hpp>

#include <gtest/gtest.h>

#include <string>

namespace {

namespace ph = passive_haptics;
using ph::runtime::device_description;

ph::runtime::catalogue catalogue_of_mechanisms() {
  ph::runtime::catalogue all;
  example::for_each_mechanism(
      [&]<class M, class P>(const std::string& name) { all.add_mechanism<M, P>(name); });
  example::add_urdf_reader(all);
  return all;
}

// The mechanism of a device file in tests/interop/robots.
device_description read(const std::string& keys,
                        const ph::runtime::catalogue& all = catalogue_of_mechanisms()) {
  ph::runtime::device_reader reader(
      ph::runtime::toml_section::text(PASSIVE_HAPTICS_SOURCE_DIR "/tests/interop/robots/device.toml",
                                      "[mechanism]\n" + keys),
      all);
  reader.read_mechanism();
  return std::move(reader.device);
}

std::string error_of(const std::string& keys, const ph::runtime::catalogue& all = catalogue_of_mechanisms()) {
  try {
    read(keys, all);
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    return text.substr(text.find("device.toml:") + 11);
  }
  return "none";
}

constexpr const char *baxter = "urdf = \"baxter.urdf\"\nbase = \"torso\"\ntip = \"left_gripper\"\n",
                     *leg = "urdf = \"anymal_leg.urdf\"\nbase = \"base\"\ntip = \"LF_FOOT\"\n",
                     *pendulum = "urdf = \"double_pendulum.urdf\"\nbase = \"base_link\"\ntip = \"link2\"\n";

TEST(urdf_of_a_device_file, is_the_mechanism_of_the_catalogue_that_it_fits) {
  EXPECT_EQ(read(baxter).mechanism.name, "spatial_chain_7_with_inertia");
  EXPECT_EQ(read(leg).mechanism.name, "spatial_chain_3_with_inertia");
  EXPECT_EQ(read(pendulum).mechanism.name, "planar_chain_2_with_inertia");
  const auto made = read(baxter + std::string("rotor_inertia = 0.01\ntool = [0, 0, 0.1]\n"));
  const auto p = made.mechanism.parameters.as<example::heavy_chain_parameters<7, 3>>();
  EXPECT_EQ(p.inertia.rotor_inertia[6], 0.01) << "a key of the section";
  EXPECT_EQ(p.inertia.links[0].mass, 5.70044) << "the file";
  const auto without = read(baxter).mechanism.parameters.as<example::heavy_chain_parameters<7, 3>>();
  EXPECT_NEAR((p.geometry.handle - without.geometry.handle).norm(), 0.1, 1e-15);
}

TEST(urdf_of_a_device_file, that_is_wrong_is_reported_with_file_and_line) {
  const std::string robots = "[mechanism] URDF " PASSIVE_HAPTICS_SOURCE_DIR "/tests/interop/robots/";
  EXPECT_EQ(error_of("urdf = \"no.urdf\"\n"), ":2: " + robots + "no.urdf: no such file");
  EXPECT_EQ(error_of(baxter + std::string("type = \"planar_chain_2_with_inertia\"\n")),
            ":5: [mechanism] type = \"planar_chain_2_with_inertia\": expected spatial_chain_7_with_inertia, "
            "which has as many joints as " +
                robots.substr(12) + "baxter.urdf");
  EXPECT_EQ(error_of("urdf = \"kinova.urdf\"\nbase = \"j2s6s200_link_1\"\ntip = \"j2s6s200_end_effector\"\n"),
            ":2: " + robots +
                "kinova.urdf: moving joints = 5: expected 2 to 4 in one plane, or 3, 6 or 7 in space; choose "
                "other links");
  EXPECT_EQ(error_of("urdf = 7"), ":2: mechanism.urdf = 7: expected a text in quotes");
  EXPECT_EQ(error_of(baxter, ph::runtime::catalogue()),
            ":2: mechanism.urdf = 'baxter.urdf': expected a program that reads URDFs; install Debian's "
            "liburdfdom-dev, then build it again");
}

}  // namespace
