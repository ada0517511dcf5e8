// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "image/image.h"
#include "report/report.h"

namespace gnomon::report {
namespace {

namespace fs = std::filesystem;

/// An empty folder of this test's own, removed with it.
class Page : public testing::Test {
 protected:
  void SetUp() override {
    directory_ =
        fs::path(testing::TempDir()) /
        (std::string("gnomon_page_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(directory_);
  }
  void TearDown() override { fs::remove_all(directory_); }

  [[nodiscard]] std::string file(const std::string& name) const { return (directory_ / name).string(); }

  std::string write(const std::vector<TestResult>& results) const {
    const Result<Done> written = write_page(directory_.string(), results,
                                            {.title = "Suite", .renderer = "llvmpipe", .version = "0.1.0"});
    EXPECT_TRUE(written.ok());
    std::ifstream stream(directory_ / "index.html", std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  std::string picture(const std::string& name, int width, int height) const {
    fs::create_directories(fs::path(file(name)).parent_path());
    const auto bytes = 3U * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    EXPECT_TRUE(image::write_png(file(name), {width, height, std::vector<unsigned char>(bytes, 128)}).ok());
    return file(name);
  }

  fs::path directory_;
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TestResult failed_test(const std::string& id) {
  return {.id = id,
          .description = "A cone",
          .status = Status::kFailed,
          .verdicts = {{.expectation = "golden",
                        .measured = "9 of 64 pixels differ",
                        .limit = "at most 0",
                        .worst = judge::WorstPixel{12, 30, "k_shadow", double{0.4F}, 1}}},
          .reproduce = "gnomon test --filter x",
          .accept = "gnomon test --update-goldens changed"};
}

TEST_F(Page, ShowsEveryTestWithItsNumbersAndCommands) {
  const std::string page =
      write({{.id = "a/passes"}, failed_test("a/fails"), {.id = "a/odd", .status = Status::kSkipped}});
  for (const char* part :
       {"Suite", "llvmpipe", "0.1.0", "1 passed, 1 failed, 1 skipped", "a/passes", "a/fails", "a/odd",
        "A cone", "9 of 64 pixels differ", "at most 0", "(12, 30): k_shadow is 0.4, expected 1",
        "gnomon test --filter x", "gnomon test --update-goldens changed"}) {
    EXPECT_TRUE(contains(page, part)) << part;
  }
  EXPECT_FALSE(contains(page, "{{")) << "a tag of the template is left";
}

TEST_F(Page, PutsFailedTestsFirstAndOpensOnlyThem) {
  const std::string page =
      write({{.id = "a/passes"},
             {.id = "a/skipped", .status = Status::kSkipped},
             failed_test("b/fails"),
             {.id = "c/invalid", .status = Status::kInvalid, .error = "c.json:3: unknown key"}});
  const auto position = [&](const std::string& id) { return page.find("id=\"" + id + "\""); };
  EXPECT_LT(position("b/fails"), position("c/invalid"));
  EXPECT_LT(position("c/invalid"), position("a/skipped"));
  EXPECT_LT(position("a/skipped"), position("a/passes"));
  ASSERT_NE(position("a/passes"), std::string::npos);
  EXPECT_TRUE(contains(page, "id=\"b/fails\" open>"));
  EXPECT_TRUE(contains(page, "id=\"c/invalid\" open>"));
  EXPECT_TRUE(contains(page, "c.json:3: unknown key"));
  EXPECT_EQ(count(page, " open>"), 2U);
}

TEST_F(Page, EscapesWhateverAScenesAuthorWrote) {
  const std::string attack = "<script>alert(1)</script>\"'&";
  TestResult result = failed_test(attack);
  result.scene_file = result.description = result.error = result.reproduce = result.accept = attack;
  result.golden_note = result.verdicts[0].expectation = result.verdicts[0].measured = attack;
  result.verdicts[0].limit = result.verdicts[0].worst->channel = attack;
  result.expected_exr = attack;
  result.actual_png = picture("images/" + std::string("<script>alert(1)<script>") + ".png", 2, 2);
  const std::string page = write({result});
  EXPECT_TRUE(contains(page, "&lt;script&gt;alert(1)"));
  EXPECT_FALSE(contains(page, "<script>alert"));
  EXPECT_FALSE(contains(page, "\"'&\""));
}

TEST_F(Page, LinksPicturesRelativeToItself) {
  TestResult result = failed_test("a/fails");
  result.expected_png = picture("images/a@q=1,k=#0 50%-expected.png", 8, 4);
  result.actual_exr = file("images/a-actual.exr");
  result.expected_exr = (directory_.parent_path() / "goldens/a.exr").string();
  const std::string page = write({result});
  EXPECT_TRUE(contains(page, "src=\"images/a%40q%3D1%2Ck%3D%230%2050%25-expected.png\""));
  EXPECT_TRUE(contains(page, "href=\"images/a-actual.exr\""));
  EXPECT_TRUE(contains(page, "href=\"../goldens/a.exr\""));
  EXPECT_FALSE(contains(page, directory_.string())) << "a page can be moved";
}

TEST_F(Page, EnlargesSmallPicturesByAWholeNumberAndReducesLargeOnes) {
  TestResult result = failed_test("a/fails");
  result.expected_png = picture("small.png", 100, 50);
  result.actual_png = picture("large.png", 720, 7200);
  const std::string page = write({result});
  EXPECT_TRUE(contains(page, "width=\"300\" height=\"150\" loading=\"lazy\" class=\"small\""));
  EXPECT_TRUE(contains(page, "width=\"36\" height=\"360\" loading=\"lazy\">"));
}

TEST_F(Page, SaysWhereAPictureIsMissing) {
  TestResult result = failed_test("a/fails");
  result.actual_png = picture("actual.png", 8, 8);
  result.expected_png = file("never-written.png");
  std::ofstream(file("broken.png")) << "not a picture";
  result.difference_png = file("broken.png");
  const std::string page = write({result});
  EXPECT_EQ(count(page, "<img "), 1U);
  EXPECT_EQ(count(page, "no picture</div>"), 2U);
}

TEST_F(Page, OfNoTestsIsAPageToo) {
  EXPECT_TRUE(contains(write({}), "No test was run"));
}

TEST_F(Page, DependsOnNothingButTheOutcomes) {
  TestResult result = failed_test("a/fails");
  result.seconds = 1;
  const std::string first = write({result});
  result.seconds = 2;
  EXPECT_EQ(write({result}), first);
}

TEST_F(Page, NeedsNothingFromElsewhere) {
  const std::string page = write({failed_test("a/fails")});
  for (const char* part : {"http:", "https:", "<link", "@import", "src=\"//"})
    EXPECT_FALSE(contains(page, part)) << part;
}

TEST_F(Page, ThatCannotBeWrittenIsAFailureOfTheMachine) {
  fs::create_directories(directory_);
  std::ofstream(file("occupied")) << "a file";
  fs::create_directories(file("taken/index.html"));
  for (const std::string& directory : {file("occupied"), file("occupied/below"), file("taken")}) {
    const Result<Done> written = write_page(directory, {}, {});
    ASSERT_FALSE(written.ok()) << directory;
    EXPECT_EQ(written.diagnostics().at(0).failure, Failure::kMachine);
    EXPECT_TRUE(contains(written.diagnostics().at(0).file, directory));
  }
}

}  // namespace
}  // namespace gnomon::report
