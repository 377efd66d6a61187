// Comparison of printed tables with docs/results.md.
#pragma once

#include "markdown.hpp"

#include <page_tables.hpp>

#include <filesystem>

namespace experiments {

inline const std::filesystem::path results_page = PASSIVE_HAPTICS_SOURCE_DIR "/docs/results.md";

// True if docs/results.md has these tables. PASSIVE_HAPTICS_WRITE_PAGES=1 writes them there.
bool is_printed(const page_tables& tables);

}  // namespace experiments
