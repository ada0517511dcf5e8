// SPDX-License-Identifier: MIT
// Which device is taken on machines of every kind, and what is said where none is.
#include "gl/choice.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gnomon::gl {
namespace {

const Device kGpu{.egl_device = 0,
                  .place = "EGL device /dev/dri/card0",
                  .software = false,
                  .renderer = "NVIDIA H100 80GB HBM3/PCIe/SSE2"};
const Device kSecondGpu{.egl_device = 1,
                        .place = "EGL device /dev/dri/card1",
                        .software = false,
                        .renderer = "AMD Radeon RX 6800"};
const Device kSoftware{
    .egl_device = 2, .place = "EGL device", .software = true, .renderer = "llvmpipe (LLVM 15.0.6, 256 bits)"};
const Device kSurfaceless{.place = "EGL surfaceless platform",
                          .renderer = "llvmpipe (LLVM 15.0.6, 256 bits)"};
const Device kOsmesa{
    .api = Api::kOsmesa, .place = "OSMesa", .software = true, .renderer = "llvmpipe (LLVM 15.0.6, 256 bits)"};

Device broken(Device device, const std::string& failure) {
  device.failure = failure;
  return device;
}

/// The number of the device that is taken, or what is said instead.
std::string taken(const Found& found, const Request& request = {}) {
  const Result<Choice> choice = choose(found, request);
  return choice ? std::to_string(choice->device) : to_string(choice.diagnostics().front());
}

std::string reason(const Found& found, const Request& request = {}) {
  const Result<Choice> choice = choose(found, request);
  return choice ? choice->reason : "";
}

#define EXPECT_SAYS(text, part) EXPECT_NE(std::string(text).find(part), std::string::npos) << (text)

TEST(Choice, AutoTakesHardwareThenSoftwareEglThenOsmesaInWhateverOrderTheyAreListed) {
  std::vector<Device> order{kGpu, kSecondGpu, kSurfaceless, kSoftware, kOsmesa};
  while (!order.empty()) {
    std::vector<Device> shuffled = order;
    for (std::size_t turn = 0; turn < order.size(); ++turn) {
      const Result<Choice> choice = choose({.devices = shuffled}, {});
      ASSERT_TRUE(choice);
      // Two GPUs are taken in the order of their list.
      const bool two_gpus = order.size() == 5;
      const std::string place = shuffled[choice->device].place;
      EXPECT_TRUE(place == order.front().place || (two_gpus && place == kSecondGpu.place)) << place;
      std::rotate(shuffled.begin(), shuffled.begin() + 1, shuffled.end());
    }
    order.erase(order.begin());
  }
}

TEST(Choice, DeviceOfUnknownKindIsTriedBeforeSoftware) {
  Device unknown = kGpu;
  unknown.software.reset();
  EXPECT_EQ(taken({.devices = {kSoftware, kSurfaceless, unknown}}), "2");
  unknown.software = true;  // it turned out to be none
  EXPECT_EQ(taken({.devices = {kSoftware, kSurfaceless, unknown}}), "1");
}

TEST(Choice, DeviceThatGivesNoContextIsPassedOverAndTheReasonSaysSo) {
  const Found found{.devices = {broken(kGpu, "eglInitialize failed"), kSoftware, kSurfaceless, kOsmesa}};
  EXPECT_EQ(taken(found), "2");
  EXPECT_SAYS(reason(found), "no hardware EGL device works");
  EXPECT_SAYS(reason({.devices = {kSoftware, kSurfaceless}}), "no hardware EGL device was found");
}

TEST(Choice, OsmesaIsTakenWhereEglIsMissingAndTheReasonSaysSo) {
  const Found found{.devices = {kOsmesa}, .egl_lacks = "libEGL.so.1 cannot be loaded; the package libegl1"};
  EXPECT_EQ(taken(found), "0");
  EXPECT_EQ(reason(found), "EGL offers no device; OSMesa comes last");
}

TEST(Choice, BackendByNameTakesItsOwnOnly) {
  const Found found{.devices = {kGpu, kSurfaceless, kOsmesa}};
  EXPECT_EQ(taken(found, {.api = Api::kOsmesa}), "2");
  EXPECT_EQ(taken(found, {.api = Api::kEgl}), "0");
  EXPECT_SAYS(reason(found, {.api = Api::kOsmesa}), "--backend osmesa");
}

TEST(Choice, AbsentBackendIsNinetyNineAndNamesItsPackage) {
  const Found no_osmesa{
      .devices = {kSurfaceless},
      .osmesa_lacks = "libOSMesa.so.8 cannot be loaded; the Debian package libosmesa6 brings it"};
  const Result<Choice> choice = choose(no_osmesa, {.api = Api::kOsmesa});
  ASSERT_FALSE(choice);
  EXPECT_EQ(choice.diagnostics().front().failure, Failure::kMachine);
  EXPECT_SAYS(taken(no_osmesa, {.api = Api::kOsmesa}), "'--backend osmesa': libOSMesa.so.8");
  EXPECT_SAYS(taken(no_osmesa, {.api = Api::kOsmesa}), "libosmesa6");
  EXPECT_EQ(taken(no_osmesa), "0") << "auto does not mind";
  const Found no_egl{.devices = {kOsmesa}, .egl_lacks = "libEGL.so.1 cannot be loaded; libegl1"};
  EXPECT_SAYS(taken(no_egl, {.api = Api::kEgl}), "libegl1");
}

TEST(Choice, DeviceByNumberAndByPartOfItsNameInAnyCase) {
  const Found found{.devices = {kGpu, kSecondGpu, kSoftware, kSurfaceless, kOsmesa}};
  EXPECT_EQ(taken(found, {.device = "1"}), "1");
  EXPECT_EQ(taken(found, {.device = "4"}), "4");
  EXPECT_EQ(taken(found, {.device = "radeon"}), "1");
  EXPECT_EQ(taken(found, {.device = "/dev/dri/card1"}), "1");
  EXPECT_EQ(taken(found, {.device = "Surfaceless"}), "3");
  EXPECT_EQ(taken(found, {.device = "llvmpipe"}), "3")
      << "the surfaceless platform, auto's first of the three";
  EXPECT_EQ(taken(found, {.api = Api::kOsmesa, .device = "llvmpipe"}), "4");
  EXPECT_SAYS(reason(found, {.device = "radeon"}), "--device radeon");
}

TEST(Choice, DeviceThatMatchesNothingIsToldWhichThereAre) {
  const Found found{.devices = {kGpu, kSoftware, kOsmesa}};
  for (const char* wanted : {"3", "geforce", "00", "-1", "99999999999999999999"}) {
    const std::string said = taken(found, {.device = wanted});
    EXPECT_SAYS(said, "'--device " + std::string(wanted) + "' matches none of the devices");
    EXPECT_SAYS(said, "device 0 egl: NVIDIA H100 80GB HBM3/PCIe/SSE2, hardware, EGL device /dev/dri/card0");
    EXPECT_SAYS(said, "device 2 osmesa: llvmpipe");
  }
  // With a back end, only its own are listed.
  const std::string said = taken(found, {.api = Api::kOsmesa, .device = "0"});
  EXPECT_SAYS(said, "device 2 osmesa");
  EXPECT_EQ(said.find("device 0 egl"), std::string::npos) << said;
}

TEST(Choice, DeviceThatMatchesButFailsSaysWhy) {
  const Found found{.devices = {broken(kGpu, "eglInitialize failed (EGL error 0x3001)"), kOsmesa}};
  const std::string said = taken(found, {.device = "0"});
  EXPECT_SAYS(said, "'--device 0' gives no OpenGL context");
  EXPECT_SAYS(said, "0x3001");
}

TEST(Choice, MachineWithoutAnyNamesEverythingThatIsMissing) {
  const Found found{.devices = {broken(kGpu, "it has no OpenGL 4.5 core profile")},
                    .osmesa_lacks = "the Debian package libosmesa6 brings it"};
  const Result<Choice> choice = choose(found, {});
  ASSERT_FALSE(choice);
  EXPECT_EQ(choice.diagnostics().front().failure, Failure::kMachine);
  EXPECT_SAYS(taken(found), "no OpenGL 4.5 core profile");
  EXPECT_SAYS(taken(found), "libosmesa6");
  EXPECT_SAYS(taken(found), "--backend cpu");
  const Found nothing{.egl_lacks = "the Debian package libegl1", .osmesa_lacks = "libosmesa6"};
  EXPECT_SAYS(taken(nothing, {.device = "0"}), "no OpenGL 4.5 context");  // no list of no devices
  EXPECT_SAYS(taken(nothing, {.device = "0"}), "libegl1");
}

}  // namespace
}  // namespace gnomon::gl
