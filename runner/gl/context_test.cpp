// SPDX-License-Identifier: MIT
// Contexts of both back ends, one after the other and side by side. scripts/setup installs what both need.
#include "gl/context.h"

#include <glad/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>

#include "gl/egl.h"
#include "gl/osmesa.h"
#include "gl/texture.h"

namespace gnomon::gl {
namespace {

Context make(Api api) {
  Result<Context> context = Context::create({.api = api});
  if (!context) throw std::runtime_error(to_string(context.diagnostics().front()));
  return std::move(context).value();
}

std::string renderer() {
  return reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

/// Whether the current context uploads and downloads a texel.
bool works() {
  Result<Texture> texture = Texture::create(Format::kR32F, {1, 1});
  if (!texture) return false;
  const std::array<float, 1> value{42.25F};
  texture->upload(value);
  return texture->download() == std::vector<float>{42.25F} && glGetError() == GL_NO_ERROR;
}

/// A context as drivers without the extensions need it.
void expect_works_with(EglMeans means) {
  const EglListing listing = list_egl();
  for (const Device& device : listing.devices) {
    Opened opened = open_egl(device.egl_device, means);
    if (!opened.native) continue;
    ASSERT_EQ(opened.native->make_current(), "");
    ASSERT_TRUE(gladLoadGL(opened.native->loader()));
    EXPECT_TRUE(works()) << device.place;
    opened.native->release();
    return;
  }
  ADD_FAILURE() << "no EGL device gives a context";
}

TEST(GlContext, EglWithAConfigAndAPixelBufferWhereExtensionsAreMissing) {
  ASSERT_EQ(list_egl().lacks, "");
  expect_works_with({.no_config = false, .surfaceless = true});
  expect_works_with({.no_config = true, .surfaceless = false});
  expect_works_with({.no_config = false, .surfaceless = false});
}

TEST(GlContext, EveryEglDeviceIsListedAndTriedByTheSurvey) {
  ASSERT_EQ(list_egl().lacks, "");
  const Found found = Context::survey();
  ASSERT_GE(found.devices.size(), list_egl().devices.size());
  for (const Device& device : found.devices)
    EXPECT_NE(device.renderer.empty() && device.version.empty(), device.failure.empty()) << device.place;
}

TEST(GlContext, BackEndsTakeTurns) {
  ASSERT_EQ(list_egl().lacks, "");
  ASSERT_EQ(osmesa_lacks(), "");
  for (int turn = 0; turn < 3; ++turn) {
    for (const Api api : {Api::kEgl, Api::kOsmesa}) {
      const Context context = make(api);
      EXPECT_EQ(context.info().device.api, api);
      EXPECT_EQ(renderer(), context.info().renderer);
      EXPECT_TRUE(works());
    }
  }
}

TEST(GlContext, BackEndsStandSideBySideAndCallsGoToTheCurrentOne) {
  ASSERT_EQ(list_egl().lacks, "");
  ASSERT_EQ(osmesa_lacks(), "");
  Context egl = make(Api::kEgl);
  // Buffer names count from 1 in each context: what one holds the other must not see.
  GLuint egl_buffer = 0;
  glCreateBuffers(1, &egl_buffer);
  std::optional<Context> osmesa = make(Api::kOsmesa);
  EXPECT_FALSE(glIsBuffer(egl_buffer));
  EXPECT_TRUE(works());
  ASSERT_TRUE(egl.make_current());
  EXPECT_TRUE(glIsBuffer(egl_buffer));
  EXPECT_TRUE(works());
  ASSERT_TRUE(osmesa->make_current());
  EXPECT_FALSE(glIsBuffer(egl_buffer));
  ASSERT_TRUE(egl.make_current());
  osmesa.reset();
  EXPECT_TRUE(glIsBuffer(egl_buffer)) << "the current context stays so while another one ends";
  EXPECT_TRUE(works());
}

TEST(GlContext, CurrentContextStaysSoWhileOthersAreTried) {
  ASSERT_EQ(list_egl().lacks, "");
  const Context context = make(Api::kEgl);
  GLuint buffer = 0;
  glCreateBuffers(1, &buffer);
  static_cast<void>(Context::survey());
  EXPECT_TRUE(glIsBuffer(buffer));
  EXPECT_FALSE(Context::create({.device = "999"}));
  EXPECT_TRUE(glIsBuffer(buffer));
}

TEST(GlContext, TwoOfOneDisplayOutliveEachOther) {
  ASSERT_EQ(list_egl().lacks, "");
  std::optional<Context> first = make(Api::kEgl);
  Context second = make(Api::kEgl);
  first.reset();
  EXPECT_TRUE(works());
}

TEST(GlContext, DeviceByNumberIsTheOneThatTheSurveyLists) {
  const Found found = Context::survey();
  for (std::size_t i = 0; i < found.devices.size(); ++i) {
    if (!found.devices[i].failure.empty()) continue;
    const Result<Context> context = Context::create({.device = std::to_string(i)});
    ASSERT_TRUE(context) << to_string(context.diagnostics().front());
    EXPECT_EQ(context->info().number, i);
    EXPECT_EQ(context->info().renderer, found.devices[i].renderer);
    EXPECT_EQ(context->info().device.place, found.devices[i].place);
  }
}

TEST(GlContext, MissingDeviceIsToldWhichThereAre) {
  const Result<Context> context = Context::create({.device = "999"});
  ASSERT_FALSE(context);
  EXPECT_EQ(context.diagnostics().front().failure, Failure::kMachine);
  for (const Device& device : Context::survey().devices) {
    EXPECT_NE(to_string(context.diagnostics().front()).find(device.renderer), std::string::npos)
        << to_string(context.diagnostics().front());
  }
}

}  // namespace
}  // namespace gnomon::gl
