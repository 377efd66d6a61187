/// @file
/// The paper's figures and the first things to see, as settings.
#pragma once

namespace explorer {

/// A place to begin at, with a link of its own.
struct preset {
  const char* id;        ///< Of its link, "#v1/fig2". It never changes.
  const char* title;     ///< In words.
  const char* look;      ///< One sentence: what to look at.
  const char* settings;  ///< As explorer_new() takes them. q and qd are stored, not computed: another libm
                         ///< rounds otherwise.
};

// The two links of Figs. 2 and 3 with the handle moving along -y.
#define PAPER_ARM                                                                               \
  "mechanism=two_link\nmechanism.length_1=1\nmechanism.length_2=1\nscene=none\ndesired=given\n" \
  "law=no_direct_control\nq=0.78539816339744828,1.5707963267948966\nqd=-0.0707106781187,0.141421356237\n"
// The paper's device at the start of a hand's way along the plane of section 5.2. The brakes are just strong
// enough.
#define PAPER_HAND                                                                                   \
  "mechanism=tendon_two_link\nhand=along\nbrakes.torque_limit=0.129,0.129\nq=2.0899568901163059,-1." \
  "4400687400278886\n"                                                                               \
  "qd=-0.674537688095,1.0915359589\n"
// The slanted wall of Fig. 5 on the XY table.
#define SLANTED                                                                                       \
  "mechanism=xy_table\nbrakes.torque_limit=5,5\nscene=plane:0,0.05,0.5,-0.8660254037844386\ndesired=" \
  "given\nq=0.02,0.055\n"

/// All presets, the first things to see first.
inline constexpr preset presets[] = {
    {"bounce", "Why does it bounce?",
     "The wall's force can only be approximated, and the approximated force pulls the handle off the wall: "
     "contact and gap alternate.",
     PAPER_HAND "law=no_direct_control\n"},
    {"glide", "Which law helps?",
     "This hand under velocity_direct_control: the depth stays constant, no brake sticks, the hand glides.",
     PAPER_HAND "law=velocity_direct_control\n"},
    {"fig2", "Figure 2: what two brakes can produce",
     "Four passive FMEs, bounded by the reference forces; the motion of the handle decides in which of them "
     "a force can be made.",
     PAPER_ARM},
    {"fig3-Fd1", "Figure 3: a force that can be made",
     "F_d1 lies in the passive FME of the present motion: F_c is F_d itself, and the approximation angle is "
     "0.",
     PAPER_ARM "Fd=-0.25,0.75\n"},
    {"fig3-Fd2", "Figure 3: a force that is approximated",
     "F_d2 opposes the motion, but brake 1 would have to drive: the nearest force R2- alone is scaled until "
     "its part along F_d is F_d.",
     PAPER_ARM "Fd=0.4,0.8\n"},
    {"fig3-Fd3", "Figure 3: a force that cannot be made",
     "F_d3 points along the motion: only a motor could make it, and no brake is commanded.",
     PAPER_ARM "Fd=0.5,-0.6\n"},
    {"fig4", "Figure 4: a wall along an axis",
     "The wall's force points along a reference force: only brake 2 displays its direction exactly, and "
     "the hand slides on.",
     "mechanism=xy_table\nbrakes.torque_limit=5,5\nscene=plane:0,0.05,0,-1\nlaw=no_direct_control\n"
     "q=0.02,0.0502\nqd=0.05,0.01\nFh=0.5,1.5\n"},
    {"fig5a", "Figure 5 (a): little depth",
     "F_c is smaller than the hand's part against it: the brake slips, and the resultant still points into "
     "the wall.",
     SLANTED "law=no_direct_control\nqd=0.0433,0.025\nFh=0.3,1.5\nFd=0.4,-0.6928\n"},
    {"fig5b", "Figure 5 (b): large depth, the pull-back",
     "Brake 2 holds and takes all of the hand's force against it: what is left points out of the wall, and "
     "the handle leaves.",
     SLANTED "law=no_direct_control\nqd=0.05,0\nFh=0.3,1.5\nFd=1,-1.732\n"},
    {"fig6", "Figure 6: direct control",
     "The handle moves out, so alpha scales F_c until nothing of the resultant is left normal to the wall.",
     SLANTED "law=direct_control\nqd=0.05,0\nFh=0.3,1.5\nFd=1,-1.732\n"},
    {"fig7", "Figure 7: the paper's device",
     "Both brakes stand at the base; a tendon with the reduction k2 = 0.4 drives link 2.",
     "mechanism=tendon_two_link\nscene=none\nq=1.8368763740210565,-1.4594553124539325\n"},
    {"fig8-none", "Figure 8: along a wall without direct control",
     "Contact and non-contact alternate, and brake 2 sticks and slips.",
     PAPER_HAND "law=no_direct_control\nscene.rate=1000\n"},
    {"fig8", "Figure 8: along a wall with direct control",
     "The brakes are limited before α is applied, as in the paper's experiments: the depth stays nearly "
     "constant.",
     PAPER_HAND "law=saturated_direct_control\nscene.rate=1000\n"},
    {"fig9-none", "Figure 9: the environment at 20 Hz, without",
     "The wall is updated 20 times a second only: the bounces grow.",
     PAPER_HAND "law=no_direct_control\nscene.rate=20\n"},
    {"fig9", "Figure 9: the environment at 20 Hz, with direct control",
     "The path stays smooth although the wall is updated 20 times a second only.",
     PAPER_HAND "law=saturated_direct_control\nscene.rate=20\n"},
    {"fig10-concave", "Figure 10: inside of a circle at 20 Hz",
     "The hand follows the inside of a circle of 0.325 m, under direct control with the limit first.",
     PAPER_HAND "law=saturated_direct_control\nscene.rate=20\nscene=hollow:0.11,-0.1,0.325\n"
                "q=2.1160365140984658,-1.5042503337422632\nqd=-0.657216206263,1.0552244886\n"},
    {"fig10-convex", "Figure 10: outside of a circle at 20 Hz",
     "The hand follows the outside of a circle of 0.325 m, under direct control with the limit first.",
     PAPER_HAND "law=saturated_direct_control\nscene.rate=20\nscene=solid:0.11,0.55,0.325\n"
                "q=2.0622815679455382,-1.3733660046828329\nqd=-0.694605752503,1.13357657547\n"},
    {"wall", "The paper's device at its wall",
     "Far out on the wall the approximation angle grows: turn the velocity and see which force is nearest.",
     "mechanism=tendon_two_link\nlaw=direct_control\nq=1.6352759066114992,-1.108504851001068\n"
     "qd=-0.314448465631,0.275585167518\nFh=0.8,1.6\n"},
    {"edge", "Around an edge", "Pull the handle along one face of the edge and around its corner.",
     "mechanism=tendon_two_link\nlaw=velocity_direct_control\n"
     "scene=outline:0.1,0.215,0.97,0.717,-0.77,0.717\n"
     "q=2.0409699934215944,-1.4919591304304407\n"},
    {"outline", "The outline of a body",
     "Touch the body from all sides: it has corners that stand out and one that leads in.",
     "mechanism=tendon_two_link\nlaw=velocity_direct_control\n"
     "scene=outline:0.06,0.17,0.14,0.17,0.14,0.25,0.11,0.25,0.1,0.21,0.09,0.25,0.06,0.25\n"
     "q=2.0899568901163059,-1.4400687400278886\n"},
    {"five-bar", "A five-bar with two brakes",
     "Two brakes at the base and a closed loop: the reference forces turn with the handle.",
     "mechanism=five_bar\nlaw=direct_control\nq=2.1642877537573155,0.75037122373221854\n"
     "qd=-0.634292394399,-0.490406093587\nFh=0.5,1.5\n"},
    {"four-brakes", "A five-bar with four brakes",
     "Two brakes more, on the difference and the sum of the base angles: far more forces can be made "
     "exactly.",
     "mechanism=five_bar_4\nlaw=direct_control\nq=2.1642877537573155,0.75037122373221854\n"
     "qd=-0.634292394399,-0.490406093587\nFh=0.5,1.5\n"},
    {"three-links", "One link more than needed",
     "The arm can give way without the handle moving, until one of its brakes is at rest: then the others "
     "make the force.",
     "mechanism=planar_3r\nlaw=direct_control\n"
     "q=2.1301444221519814,-1.1193585324007049,-1.0518235783084788\n"
     "qd=-0.284479770398,0.0761454136403,0.172871912211\nFh=0.5,1.5\n"},
    {"one-brake", "Would my device do?",
     "Without brake 1 the device makes forces along one line only: the design map shows where that is "
     "enough.",
     "mechanism=two_link\nlaw=direct_control\nbrakes.present=0,1\n"
     "q=1.6352759066114992,-1.108504851001068\nqd=-0.314448465631,0.275585167518\nFh=0.8,1.6\n"},
    {"delta", "A delta in space",
     "Three brakes and a platform that keeps its attitude, above a horizontal wall.",
     "mechanism=delta\nlaw=direct_control\nq=0.69631101962358444,0.67452869226310108,0.97423834676896415\n"
     "qd=-0.260941711133,0.138061671879,0.399842976689\nFh=0.2,0.1,-1.5\n"},
    {"arm", "An arm in space",
     "A turning base, shoulder and elbow with a brake each, above a horizontal wall.",
     "mechanism=spatial_3r\nlaw=direct_control\n"
     "q=0.32175055439664385,0.080118624992788892,-1.564858271065162\n"
     "qd=0.225,-0.0460507315111,0.556280640673\nFh=0.2,0.1,-1.5\n"},
};

#undef PAPER_ARM
#undef PAPER_HAND
#undef SLANTED

}  // namespace explorer
