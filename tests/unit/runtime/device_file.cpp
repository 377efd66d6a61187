// no sanitizers
// Device files: what is read, and the line that each mistake gets, with file, line, key, expectation and the
// nearest name.
#if __has_include(<toml++/toml.h>)

#include <catalogue/catalogue.hpp>

#include <passive_haptics/control/laws/on_off_control.hpp>
#include <passive_haptics/runtime/device_file/device_text.hpp>
#include <passive_haptics/runtime/device_file/read_device.hpp>

#include <gtest/gtest.h>

#include <array>
#include <span>
#include <string>
#include <vector>

namespace {

namespace ph = passive_haptics;
using ph::runtime::toml_section;

ph::runtime::device_description read(toml_section file) {
  const auto device = ph::runtime::read_device(file, example::catalogue());
  file.section("sensor").pass_over_others();
  if (file.has("homing")) file.pass_over("homing");
  file.finish();
  return device;
}
ph::runtime::device_description read(const std::string& text) {
  return read(toml_section::text("device.toml", text));
}

// As it is thrown; empty if the text is right.
std::string error_of(const std::string& text) {
  try {
    read(text);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

// Beginnings of files.
constexpr const char* usual = "";
constexpr const char* pantograph = "[mechanism]\ntype = \"five_bar\"\n";
constexpr const char* in_space = "[mechanism]\ntype = \"delta\"\n";
constexpr const char* chain = "[mechanism]\ntype = \"planar_chain_3\"\nhandle = [0.3, 0]\n";
constexpr const char* arm =
    "[mechanism]\ntype = \"planar_chain_3\"\nhandle = [0.3, 0]\n[[mechanism.joints]]\npoint = [0, 0]\n"
    "[[mechanism.joints]]\npoint = [0.1, 0]\n[[mechanism.joints]]\npoint = [0.2, 0]\n";

struct mistake {
  const char* device;
  const char* text;   // that follows
  const char* error;  // behind "device.toml"; ... for what a new entry would change
};

bool is_as(const std::string& error, const std::string& expected) {
  const std::size_t dots = expected.find("...");
  if (dots == expected.npos) return error == expected;
  return error.starts_with(expected.substr(0, dots)) && error.ends_with(expected.substr(dots + 3));
}

constexpr mistake mistakes[] = {
    // mechanism
    {usual, "[mechanism]\ntype = \"five_bra\"",
     ":2: mechanism.type = 'five_bra': expected one of \"tendon_two_link\", ...; did you mean \"five_bar\"?"},
    {usual, "mechanism = \"five_bar\"", ":1: mechanism = 'five_bar': expected a table, [mechanism]"},
    {usual, "[mecanism]\ntype = \"five_bar\"",
     ":1: unknown key 'mecanism': expected one of allow_large, brakes, effects, law, mechanism, scene, "
     "sensor, walls; did you mean \"mechanism\"?"},
    {pantograph, "proximal1 = 0.06",
     ":3: unknown key 'mechanism.proximal1': expected one of assembly, base_distance, distal_1, distal_2, "
     "distal_mass, gravity, handle_mass, proximal_1, proximal_2, proximal_mass, rotor_inertia, type; did you "
     "mean \"proximal_1\"?"},
    {usual, "[mechanism]\nlength_1 = 150",
     ":2: [mechanism] length_1 [m] = 150: expected at most 100; if it is meant, allow_large = "
     "[\"length_1\"]"},
    {usual, "[mechanism]\nlength_1 = -1", ":2: [mechanism] length_1 [m] = -1: expected a finite number > 0"},
    {usual, "[mechanism]\nlength_1 = \"0.15\"",
     ":2: mechanism.length_1 = '0.15': expected a number: a finite number > 0 [m]"},
    {usual, "[mechanism]\nlength_1 = [0.15, 0.15]",
     ":2: mechanism.length_1 = [ 0.15, 0.15 ]: expected a number: a finite number > 0 [m]"},
    {pantograph, "assembly = \"lft\"",
     ":3: mechanism.assembly = 'lft': expected one of \"left\", \"right\"; did you mean \"left\"?"},
    {pantograph, "base_distance = 0.5",
     ":1: [mechanism] longest length [m] = 0.5: expected less than all others together"},
    {pantograph, "gravity = 9.81",
     ":3: mechanism.gravity = 9.81: expected 2 numbers: a finite number [m/s^2]"},
    {pantograph, "rotor_inertia = [1e-4, 1e-4, 1e-4]",
     ":3: mechanism.rotor_inertia = [ 1e-04, 1e-04, 1e-04 ]: expected 2 numbers, or one for all: a finite "
     "number >= 0 [kg m^2]"},
    {chain, "[[mechanism.joints]]\npoint = [0, 0]\n[[mechanism.joints]]\npoint = [0.1, 0]",
     ":4: mechanism.joints = [ a table, a table ]: expected 3 tables, [[mechanism.joints]] each"},
    {arm, "kind = \"prismtic\"",
     ":10: mechanism.joints[2].kind = 'prismtic': expected one of \"revolute\", \"prismatic\"; did you mean "
     "\"prismatic\"?"},
    {arm, "points = [0.2, 0]",
     ":10: unknown key 'mechanism.joints[2].points': expected one of axis, kind, point; did you mean "
     "\"point\"?"},
    {arm, "kind = \"prismatic\"", ":8: [mechanism] joints[2].|axis| = 0: expected a direction"},
    {usual,
     "[mechanism]\ntype = \"planar_chain_3\"\n[[mechanism.joints]]\npoint = [0, "
     "0]\n[[mechanism.joints]]\npoint = [0.1, 0]\n[[mechanism.joints]]\npoint = [0.2, 0]\n",
     ":1: [mechanism] handle[0] [m] = nan: expected a finite number"},
    // brakes
    {usual, "[brakes]\ntorque_limit = [1, -1]",
     ":2: [brakes] torque_limit[1] [N m] = -1: expected a finite number >= 0"},
    {in_space, "[brakes]\ntorque_limit = [1, 1]",
     ":4: brakes.torque_limit = [ 1, 1 ]: expected 3 numbers, or one for all: a finite number >= 0 [N m]"},
    {usual, "[brakes]\ntorqe_limit = 1",
     ":2: unknown key 'brakes.torqe_limit': expected one of model, rate_dead_band, time_constant, "
     "torque_dead_band, torque_limit, torque_lower, torque_upper; did you mean \"torque_limit\"?"},
    {usual, "[brakes]\ntime_constant = 20",
     ":2: [brakes] time_constant[0] [s] = 20: expected at most 1; if it is meant, allow_large = "
     "[\"time_constant\"]"},
    {usual, "[brakes]\ntorque_upper = -1",
     ":2: [brakes] torque_upper[0] [N m] = -1: expected a number >= 0, or inf for no bound"},
    {usual, "[[brakes.model]]\ntype = \"magnetorheological\"",
     ":1: brakes.model = [ a table ]: expected 2 tables [[brakes.model]], one for each brake of a "
     "tendon_two_link"},
    {usual, "[[brakes.model]]\ntype = \"magnetoreological\"",
     ":2: brakes.model[0].type = 'magnetoreological': expected one of \"coulomb\", ...; did you mean "
     "\"magnetorheological\"?"},
    {usual, "[[brakes.model]]\ntorque_limits = 0.3\n[[brakes.model]]",
     ":2: unknown key 'brakes.model[0].torque_limits': expected one of drag, fall_ratio, gain, strength, "
     "time_constant, torque_limit, type; did you mean \"torque_limit\"?"},
    {arm, "[brakes]\ntorque_lower = 0",
     ":11: [brakes] brakes have a torque_lower or torque_upper: expected none: a controller of a mechanism "
     "with more joints than task dimensions supports such brakes only in C++"},
    // law
    {usual, "law = \"direct_control\"",
     ":1: law = 'direct_control': expected a table, [law], with type = \"...\": the key was renamed"},
    {usual, "[law]\ntype = \"direct\"",
     ":2: law.type = 'direct': expected one of \"velocity_direct_control\", ...; did you mean "
     "\"direct_control\"?"},
    {arm, "[law]\ntype = \"velocity_direct_control\"",
     ":11: law.type = 'velocity_direct_control': expected one of \"on_off_control\", \"direct_control\", "
     "\"saturated_direct_control\", \"no_direct_control\": velocity_direct_control needs inertia, which a "
     "planar_chain_3 does not have"},
    {usual, "[law]\ntype = \"direct_control\"\n[sensor]\ntype = \"none\"",
     ":2: law.type = 'direct_control': expected one of \"on_off_control\", \"no_direct_control\": "
     "direct_control needs a hand force, and [sensor] has type = \"none\""},
    {usual, "[law]\ntype = \"no_direct_control\"\nvelocity_dead_band = 0.01",
     ":3: unknown key 'law.velocity_dead_band': expected one of limits, max_approximation_angle, type"},
    {usual, "[law]\nlimits = \"clamp\"",
     ":2: law.limits = 'clamp': expected one of \"keep_direction\", \"clamp_each\"; did you mean "
     "\"clamp_each\"?"},
    {usual, "[law]\nmax_approximation_angle = 89",
     ":2: [law] max_approximation_angle [rad] = 89: expected an angle > 0 and <= pi/2"},
    {usual, "[law]\ntype = \"on_off_control\"\nlead = -0.02",
     ":3: [law] lead [s] = -0.02: expected a finite number >= 0"},
    {usual, "[law]\ntype = \"direct_control\"\ntype = \"on_off_control\"",
     ":3: Error while parsing key-value pair: cannot redefine existing string 'type'"},
    // walls
    {usual, "[[wall]]\nnormal = [0, 1]", ":1: wall = [ a table ]: expected [[walls]]: the key was renamed"},
    {usual, "[walls]\nnormal = [0, 1]", ":1: walls = a table: expected tables, [[walls]] each"},
    {usual, "[[walls]]\ntype = \"plane\"",
     ":2: walls[0].type = 'plane': expected \"half_space\": the shape was renamed"},
    {usual, "[[walls]]\npoint = [0, 0.2]",
     ":2: walls[0].point = [ 0, 0.2 ]: expected surface_point: the key was renamed"},
    {usual, "[[walls]]\ntype = \"ball\"\nradius = 0.03\nfilling = \"hollow\"",
     ":4: walls[0].filling = 'hollow': expected inside: the key was renamed"},
    {usual, "[[walls]]\n[[walls]]\nsurface_point = [0, 0.2]\nnormal = [0, 0]",
     ":4: [walls[1]] |normal| of a half_space = 0: expected a direction"},
    {in_space, "[[walls]]\nsurface_point = [0, 0]\nnormal = [0, 0, 1]",
     ":4: walls[0].surface_point = [ 0, 0 ]: expected 3 numbers: a finite number [m]"},
    {usual, "[[walls]]\ntype = \"mesh_surface\"",
     ":2: walls[0].type = 'mesh_surface': expected one of \"half_space\", ...; the mechanism is planar"},
    {in_space, "[[walls]]\ntype = \"mesh_surface\"\nfile = \"nothing.stl\"",
     ":5: [walls[0]] mesh file nothing.stl: no such file"},
    {in_space, "[[walls]]\ntype = \"mesh_surface\"\nfile = \"part.step\"",
     ":5: [walls[0]] file = \"part.step\": expected a mesh, a .stl, .ply or .obj"},
    {usual, "[[walls]]\nstiffness = -1",
     ":2: [walls[0]] stiffness of a wall [N/m] = -1: expected a finite number >= 0"},
    {usual, "[[walls]]\nstiffness = 1e300",
     ":2: [walls[0]] stiffness of a wall [N/m] = 1e300: expected at most 1e15; if it is meant, allow_large = "
     "[\"stiffness\"]"},
    {usual, "[[walls]]\ntype = \"ball\"",
     ":1: [walls[0]] radius of a ball [m] = 0: expected a finite number > 0"},
    {usual, "[[walls]]\ntype = \"convex_polygon\"\ncorners = [[0, 0], [1, 0]]",
     ":3: [walls[0]] number of corners of a convex_polygon = 2: expected 3 to 8"},
    {usual, "[[walls]]\ntype = \"convex_polygon\"\ncorners = [[0, 0], [1, 0], [0, 1, 2]]",
     ":3: walls[0].corners = [ [ 0, 0 ], [ 1, 0 ], [ 0, 1, 2 ] ]: expected a list of points of 2 numbers "
     "each: a finite number [m]"},
    {usual, "[[walls]]\ntype = \"box\"\nhalf_extents = [0.1, 0.1]\naxes = [1, 0, 0, 1]",
     ":4: walls[0].axes = [ 1, 0, 0, 1 ]: expected 2 rows of 2 numbers: a finite number [1]"},
    {usual, "[[walls]]\ntype = \"box\"\nhalf_extents = [0.1, 0.1]\naxes = [[1, 0], [1, 1]]",
     ":4: [walls[0]] |axes^T axes - I| of a box = 1: expected orthonormal columns"},
    {usual, "[[walls]]\ntype = \"offset\"\ngrowth = 0.01\n[walls.of]\ntype = \"bal\"\nradius = 0.1",
     ":5: walls[0].of.type = 'bal': expected one of \"half_space\", ...; the mechanism is planar; "
     "did you mean \"ball\"?"},
    {usual, "[[walls]]\ntype = \"offset\"\n[walls.of]\ntype = \"ball\"\nradius = 0.1\nstiffness = 5",
     ":6: unknown key 'walls[0].of.stiffness': expected one of centre, inside, radius, type"},
    {in_space, "[[walls]]\ntype = \"complement\"\n[walls.of]\ntype = \"mesh_surface\"\nfile = \"part.stl\"",
     ":5: [walls[0]] of = \"mesh_surface\": expected a shape with an inside"},
    {usual, "[[walls]]\n[walls.motion]\nfrequency = -1",
     ":3: [walls[0].motion] frequency of a wall's motion [Hz] = -1: expected a finite number >= 0"},
    {usual, "[[walls]]\n[walls.motion]\namplitude = [0, 0.01]",
     ":2: [walls[0].motion] frequency of a wall's motion [Hz] = 0: expected > 0 with an amplitude"},
    {usual, "[[walls]]\n[walls.motion]\nbelt_velocity = 0.1",
     ":3: walls[0].motion.belt_velocity = 0.1: expected 2 numbers: a finite number [m/s]"},
    {usual, "[[walls]]\n[walls.motoin]\nfrequency = 1",
     ":2: unknown key 'walls[0].motoin': expected one of motion, normal, stiffness, surface_point, type; did "
     "you mean \"motion\"?"},
    {usual, "[[walls]]\ntype = \"convex_polytope\"\n[[walls.faces]]\nnormal = [0, 1]",
     ":3: [walls[0]] number of faces of a convex_polytope = 1: expected 2 to 4"},
    {usual, "[[walls]]\ntype = \"convex_polytope\"\n[[walls.faces]]\nnormal = [0, 0]",
     ":4: [walls[0]] |faces[0].normal| of a half_space = 0: expected a direction"},
    {in_space,
     "[[walls]]\ntype = \"height_field\"\nfile = \"nothing.txt\"\nspacing_x = 1e-3\nspacing_y = 1e-3",
     ":5: [walls[0]] file nothing.txt: no such file"},
    {usual, "[scene]\nperiod = -0.05",
     ":2: [scene] period of a held_scene [s] = -0.05: expected a finite number >= 0"},
    {usual, "[scene]\nrate = 20", ":2: unknown key 'scene.rate': expected one of period"},
    // effects
    {usual, "[[effects]]\nstrength = 2",
     ":1: effects[0].type is missing: expected one of \"viscous_field\", ...; the mechanism is planar"},
    {usual, "[[effects]]\ntype = \"detent\"",
     ":2: effects[0].type = 'detent': expected one of \"viscous_field\", ...; the mechanism is planar; did "
     "you mean \"detents\"?"},
    {usual, "[[effects]]\ntype = \"detents\"\nspacing = 0\n[law]\ntype = \"direct_control\"",
     ":3: [effects[0]] spacing of detents [m] = 0: expected a finite number > 0"},
    {usual,
     "[[effects]]\ntype = \"detents\"\nspacing = 0.01\nstrength = 1\n[law]\ntype = "
     "\"velocity_direct_control\"",
     ":1: scene with effects: expected one without: they need direct_control, and "
     "a mechanism with as many joints and brakes as task dimensions"},
    {usual, "[[effects]]\ntype = \"viscous_field\"\nviscosity = 5",
     ":3: effects[0].viscosity = 5: expected 2 rows of 2 numbers: a finite number [N s/m]"},
    // the whole
    {usual, "allow_large = [\"length_1\"]\n[mechanism]\nlength_1 = 0.15",
     ":1: allow_large = [\"length_1\"]: expected keys of values that no device has; remove it"},
    {usual, "[mechanism\ntype = \"five_bar\"",
     ":1: Error while parsing table header: expected ']', saw '\\n'"},
};

TEST(device_file, names_file_line_key_and_expectation_of_a_mistake) {
  for (const auto& [device, text, error] : mistakes) {
    const std::string found = error_of(std::string(device) + text);
    EXPECT_TRUE(is_as(found, std::string("device.toml") + error)) << text << "\n" << found;
  }
}

TEST(device_file, of_each_kind_ships) {
  const auto shipped = [](const char* name) {
    return read(
        toml_section::file(std::string(PASSIVE_HAPTICS_SOURCE_DIR "/examples/catalogue/devices/") + name));
  };
  const auto first_cycle = [](const ph::runtime::device_description& d, std::span<const double> x) {
    const auto& all = example::catalogue();
    const auto mechanism = d.make_mechanism(all);
    const auto q = mechanism->inverse(x);
    const std::vector<double> qd(q.size(), 0.1), force(x.size(), 1.0);
    return d.make_controller(all, *mechanism)->operator()({0, q, qd, force});
  };
  const auto paper = shipped("paper.toml");
  EXPECT_EQ(paper.law.name, "direct_control");
  EXPECT_EQ(paper.scene.period, 0.05);
  EXPECT_EQ(first_cycle(paper, std::array{0.08, 0.226}).wall_number, 0);

  const auto five_bar = shipped("five_bar.toml");
  EXPECT_EQ(five_bar.law.name, "velocity_direct_control");
  EXPECT_EQ(five_bar.brakes.torque_limit, (std::vector{0.3, 0.3}));
  EXPECT_EQ(five_bar.brakes.time_constant, (std::vector{0.008, 0.010}));
  ASSERT_EQ(five_bar.brake_models.size(), 2U);
  EXPECT_EQ(five_bar.brake_models[1].name, "magnetorheological");
  EXPECT_EQ(first_cycle(five_bar, std::array{0.0125, 0.0895}).wall_number, 0);

  const auto delta = shipped("delta.toml");
  EXPECT_EQ(delta.law.name, "on_off_control");
  EXPECT_FALSE(delta.has_force_sensor);
  EXPECT_EQ(delta.walls.size(), 2U);
  EXPECT_EQ(first_cycle(delta, std::array{0.0, 0.0, -0.1395}).outcome, ph::status::ok);
  EXPECT_EQ(first_cycle(delta, std::array{0.05, 0.0, -0.171}).wall_number, 1);
}

TEST(device_file, has_the_recommended_law_unless_it_names_one) {
  const auto lead = [](const ph::runtime::device_description& d) {
    return d.law.parameters.as<ph::on_off_parameters>().lead;
  };
  EXPECT_EQ(read("").law.name, "velocity_direct_control");
  EXPECT_EQ(read("[mechanism]\ntype = \"delta\"").law.name, "velocity_direct_control");
  const std::string none = "[brakes]\ntime_constant = [0.01, 0.03]\n[sensor]\ntype = \"none\"\n";
  EXPECT_EQ(read(none).law.name, "on_off_control");
  EXPECT_EQ(lead(read(none)), 0.03);
  EXPECT_EQ(lead(read(none + "[law]\nlead = 0.02")), 0.02);
}

TEST(device_file, has_values_of_no_device_only_if_its_user_says_so) {
  EXPECT_EQ(error_of("allow_large = [\"length_1\"]\n[mechanism]\nlength_1 = 150"), "");
  EXPECT_EQ(read("[mechanism]\nlength_1 = 15\n[[walls]]\nstiffness = 10").remarks,
            "mechanism: length_1 [m] = 15, usually within 5 m: millimetres?\n"
            "wall 1: stiffness of a wall [N/m] = 10, usually 100 to 1e9: N/mm?\n");
}

TEST(device_file, is_that_of_several_readers) {
  auto file = toml_section::text("device.toml", "[brakes]\ntorque_limit = 2\ncurrent_limit = 3\n");
  EXPECT_EQ(ph::runtime::read_device(file, example::catalogue()).brakes.torque_limit[1], 2);
  EXPECT_THROW(file.finish(), std::invalid_argument);
  double current = 0;
  file.section("brakes").read("current_limit", current);
  EXPECT_EQ(current, 3);
  file.finish();
}

TEST(device_file, has_effects_with_walls_and_without) {
  const std::string effect = "[[effects]]\ntype = \"viscous_field\"\nviscosity = [[5, 0], [0, 5]]\n";
  const auto& all = example::catalogue();
  const auto cycle_of = [&](const std::string& text, double y) {
    const auto d = read(text);
    const auto mechanism = d.make_mechanism(all);
    const auto q = mechanism->inverse(std::array{0.08, y});
    return d.make_controller(all, *mechanism)->operator()({0, q, std::array{0.1, 0.2}, std::array{0.0, 0.0}});
  };
  EXPECT_EQ(read(effect).law.name, "direct_control");
  EXPECT_EQ(read(effect).walls.size(), 0U);
  const auto resisted = cycle_of(effect, 0.2);
  EXPECT_GT(resisted.capacity[0] + resisted.capacity[1], 0.01);
  EXPECT_EQ(cycle_of(effect + "[[walls]]\n", 0.226).wall_number, 0);
  EXPECT_EQ(cycle_of("walls = []\n[law]\ntype = \"direct_control\"\n", 0.226).power, ph::power_class::none);
}

TEST(device_file, makes_shapes_of_shapes_and_of_lists) {
  const auto offset =
      read("[[walls]]\ntype = \"offset\"\ngrowth = 0.01\n[walls.of]\ntype = \"ball\"\nradius = 0.1");
  ASSERT_EQ(offset.walls[0].shapes.size(), 2U);
  EXPECT_EQ(offset.walls[0].shapes[1].name, "ball");
  read("[[walls]]\ntype = \"convex_polygon\"\ncorners = [[0, 0], [1, 0], [1, 1], [0, 1]]");
  read("[[walls]]\ntype = \"box\"\nhalf_extents = [0.1, 0.1]\naxes = [[0, -1], [1, 0]]");
}

TEST(device_file, moves_walls_by_the_time_of_a_cycle) {
  const auto& all = example::catalogue();
  const auto d =
      read("[[walls]]\n[walls.motion]\namplitude = [0, -0.02]\nfrequency = 0.25\n[scene]\nperiod = 0.5");
  const auto mechanism = d.make_mechanism(all);
  const auto q = mechanism->inverse(std::array{0.08, 0.21});  // 15 mm off the wall at rest
  const auto control = d.make_controller(all, *mechanism);
  const auto wall_at = [&](double time) {
    return (*control)({time, q, std::array{0.1, 0.2}, std::array{0.0, 0.0}}).wall_number;
  };
  EXPECT_EQ(wall_at(0), -1);
  EXPECT_EQ(wall_at(0.75), 0);
  EXPECT_EQ(wall_at(2), -1);
  EXPECT_EQ(wall_at(5), 0);
}

// With all keys, so that equal texts are equal devices.
TEST(device_file, is_written_as_it_was_read) {
  const std::string files[] = {
      "",
      "walls = []\n[sensor]\ntype = \"none\"",
      "allow_large = [\"length_1\", \"time_constant\"]\n[mechanism]\nlength_1 = 150\n[brakes]\ntime_constant "
      "= "
      "12345678901234567890.0\ntorque_upper = [inf, 0]\nrate_dead_band = 0.047936899621426284",
      "[mechanism]\ntype = \"five_bar\"\nassembly = \"right\"\n[[brakes.model]]\n[[brakes.model]]\ntype = "
      "\"presliding\"\n[law]\ntype = \"saturated_direct_control\"\nlimits = \"clamp_each\"",
      "[[walls]]\ntype = \"offset\"\nstiffness = 5\ngrowth = 0.01\n[walls.of]\ntype = \"complement\"\n"
      "[walls.of.of]\ntype = \"ball\"\nradius = 0.1\n[[walls]]\ntype = \"convex_polygon\"\ncorners = [[0, "
      "0], [1, "
      "0], [1, 1]]\n[[walls]]\ntype = \"box\"\nhalf_extents = [0.1, 0.2]\naxes = [[0, -1], [1, 0]]",
      "[[walls]]\ntype = \"convex_polytope\"\n[[walls.faces]]\nsurface_point = [0, 0.2]\nnormal = [1, -1]\n"
      "[[walls.faces]]\nsurface_point = [0, 0.2]\nnormal = [-1, -1]",
      "[[walls]]\n[walls.motion]\namplitude = [0, 0.01]\nfrequency = 0.5\nbelt_velocity = [0.1, 0]",
      "[law]\ntype = \"direct_control\"\n[[effects]]\ntype = \"viscous_field\"\nviscosity = [[5, 0], [1, "
      "6]]\n[scene]\nperiod = 0.1",
      std::string(chain) +
          "[[mechanism.joints]]\npoint = [0, 0]\n[[mechanism.joints]]\nkind = \"prismatic\"\n"
          "axis = [1, 0]\n[[mechanism.joints]]\npoint = [0.2, 0]\n"};
  for (const std::string& file : files) {
    const std::string text = ph::runtime::device_text(read(file));
    EXPECT_EQ(ph::runtime::device_text(read(text)), text);
    if (file.empty()) {
      EXPECT_NE(text.find("\nlength_1 = 0.15\n"), text.npos) << text;
    }
  }
  const auto large = read(ph::runtime::device_text(read(files[2])));
  EXPECT_EQ(large.brakes.time_constant[1], 12345678901234567890.0);
  EXPECT_EQ(large.brakes.rate_dead_band[0], 0.047936899621426284);
  auto mesh = read(toml_section::file(PASSIVE_HAPTICS_SOURCE_DIR "/examples/catalogue/devices/delta.toml"));
  const std::string text = ph::runtime::device_text(mesh);
  EXPECT_EQ(ph::runtime::device_text(read(text)), text);
}

}  // namespace

#endif
