// A model of MuJoCo from its text.
#pragma once

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <array>
#include <cstring>
#include <memory>
#include <string>

struct deleter {
  void operator()(mjModel* m) const { mj_deleteModel(m); }
  void operator()(mjData* d) const { mj_deleteData(d); }
};

inline std::unique_ptr<mjModel, deleter> load(const std::string& text) {
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "arm.xml", static_cast<int>(text.size()));
  std::memcpy(files->filedata[files->nfile - 1], text.data(), text.size());
  std::array<char, 500> error{};
  mjModel* model = mj_loadXML("arm.xml", files.get(), error.data(), static_cast<int>(error.size()));
  EXPECT_NE(model, nullptr) << error.data();
  mj_deleteFileVFS(files.get(), "arm.xml");
  return std::unique_ptr<mjModel, deleter>(model);
}
