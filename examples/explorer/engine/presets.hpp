/// @file
/// The paper's figures and the first things to see, as settings.
#pragma once

namespace explorer {

/// A place to begin at, with a link of its own.
struct preset {
  const char* id;        ///< Of its link, "#v1/fig2". It never changes.
  const char* title;     ///< In words.
  const char* look;      ///< One sentence: what to look at.
  const char* settings;  ///< As explorer_new() takes them.
};

/// All presets, those of a hand that moves by itself first.
inline constexpr preset presets[] = {
    {"fig2", "Figure 2: passive FMEs",
     "placeholder",
     "mechanism=two_link\nmechanism.length_1=1\nmechanism.length_2=1\nq=0.7853981633974483,1.5707963267948966\n"
     "scene=none\n"},
};

}  // namespace explorer
