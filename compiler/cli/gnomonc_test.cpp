// SPDX-License-Identifier: MIT
// The program as people use it: exit codes, and what reaches which stream and file.
#include "src/run_in.h"

namespace gnomon {
namespace {

class Gnomonc : public testing::Test {
 protected:
  Outcome run(const std::string& arguments) const { return run_in(tree, GNOMONC, arguments); }

  TemporaryTree tree;
};

TEST_F(Gnomonc, BuildWritesToStandardOutput) {
  tree.file("a.frag", "#version 330\nvoid main() {}");
  const Outcome built = run("build a.frag -D A -DB=2 -D C=");
  EXPECT_EQ(built.code, 0);
  EXPECT_EQ(built.out, "#version 450 core\n#define A 1\n#define B 2\n#define C \nvoid main() {}\n");
  EXPECT_EQ(built.err, "");
}

TEST_F(Gnomonc, BuildWritesAFile) {
  tree.file("a.frag", "void main() {}\n");
  const Outcome built = run("build -o out.glsl a.frag");
  EXPECT_EQ(built.code, 0);
  EXPECT_EQ(built.out, "");
  EXPECT_EQ(tree.read("out.glsl"), "#version 450 core\nvoid main() {}\n");
}

TEST_F(Gnomonc, FailureKeepsAnOlderOutput) {
  tree.file("a.frag", "#include \"b.glsl\"\nvoid main() {}\n");
  tree.file("b.glsl", "\nfloat x = y;\n");
  tree.file("out.glsl", "older");
  const Outcome built = run("build a.frag -o out.glsl");
  EXPECT_EQ(built.code, 1);
  EXPECT_EQ(built.err, "b.glsl:2: error: 'y': undeclared identifier\n  included from a.frag:1\n");
  EXPECT_EQ(tree.read("out.glsl"), "older");
  EXPECT_EQ(run("build a.frag --errfmt msvc").err,
            "b.glsl(2): error: 'y': undeclared identifier\n  included from a.frag:1\n");
}

TEST_F(Gnomonc, WrongUsageIsTwo) {
  tree.file("a.frag", "void main() {}\n");
  for (const std::string arguments :
       {"", "biuld a.frag", "build", "build a.frag b.frag", "build a.frag --target cobol",
        "build a.frag --stage x", "build a.frag --errfmt x", "build a.frag --bogus", "build a.frag -D 1x",
        "build a.frag -D gl_X=1", "build a.frag -D", "check", "list a.frag", "build none.frag", "build .",
        "check none.glsl"}) {
    const Outcome refused = run(arguments);
    EXPECT_EQ(refused.code, 2) << arguments;
    EXPECT_EQ(refused.out, "") << arguments;
    EXPECT_NE(refused.err, "") << arguments;
  }
}

TEST_F(Gnomonc, OutputMustNotBeASource) {
  tree.file("a.frag", "#include \"b.glsl\"\nvoid main() {}\n");
  tree.file("b.glsl", "// b\n");
  EXPECT_EQ(run("build a.frag -o ./b.glsl").code, 2);
  EXPECT_EQ(tree.read("b.glsl"), "// b\n");
  EXPECT_EQ(run("build a.frag -o b.glsl -MF none.d").code, 2);
  EXPECT_EQ(tree.read("none.d"), "");
}

TEST_F(Gnomonc, OutputThatIsNotWritableIsNinetyNine) {
  tree.file("a.frag", "void main() {}\n");
  EXPECT_EQ(run("build a.frag -o none/out.glsl").code, 99);
  EXPECT_EQ(run("build a.frag -o .").code, 99);
  EXPECT_EQ(run("build a.frag -o /dev/full").code, 99);
  EXPECT_EQ(run("build a.frag -o /dev/null").code, 0);
}

TEST_F(Gnomonc, SpirvNeedsAFileAndTextDoesNot) {
  tree.file("a.frag", "out vec4 o;\nvoid main() { o = vec4(1); }\n");
  const Outcome binary = run("build a.frag --target vulkan");
  EXPECT_EQ(binary.code, 2);
  EXPECT_EQ(binary.out, "");
  EXPECT_EQ(binary.err, "error: SPIR-V is binary: name a file for it with -o\n");
  EXPECT_EQ(run("build a.frag --target vulkan -o a.spv").code, 0);
  EXPECT_EQ(tree.read("a.spv").substr(0, 4), std::string("\x03\x02#\x07", 4));
  EXPECT_NE(run("build a.frag --target hlsl50").out.find("SV_Target0"), std::string::npos);
  EXPECT_NE(run("build a.frag --target header --embed vulkan --embed essl300").out.find("#version 300 es"),
            std::string::npos);
  EXPECT_EQ(run("build a.frag --target header --embed header").code, 2);
}

TEST_F(Gnomonc, ReflectionIsWrittenBesideTheOutput) {
  tree.file("a.frag", "out vec4 o;\nuniform float x;\nvoid main() { o = vec4(x); }\n");
  EXPECT_EQ(run("build a.frag -o a.glsl --reflect a.json").code, 0);
  EXPECT_NE(tree.read("a.json").find("\"name\": \"x\""), std::string::npos);
  const std::string json = tree.read("a.json");
  EXPECT_EQ(run("build a.frag -o a.glsl --reflect a.glsl").code, 2);
  EXPECT_EQ(run("build a.frag -o a.glsl --reflect a.frag").code, 2);
  EXPECT_EQ(run("build a.frag -o b.glsl --reflect none/a.json").code, 99);
  EXPECT_EQ(tree.read("b.glsl"), "");
  tree.file("a.frag", "out vec4 o;\nvoid main() { o = vec4(y); }\n");
  EXPECT_EQ(run("build a.frag -o a.glsl --reflect a.json").code, 1);
  EXPECT_EQ(tree.read("a.json"), json);
}

TEST_F(Gnomonc, CppWritesTheLibraryOrGivenModules) {
  EXPECT_NE(run("cpp").out.find("GnomonShadow gnomon_multilevel("), std::string::npos);
  tree.file("m.glsl", "float f(float x) { return x; }\n");
  EXPECT_EQ(run("cpp m.glsl -o m.h").code, 0);
  EXPECT_NE(tree.read("m.h").find("float f(float x) const { return x; }"), std::string::npos);
  tree.file("m.glsl", "float f(float x) { return y; }\n");
  EXPECT_EQ(run("cpp m.glsl -o m.h").code, 1);
  EXPECT_NE(tree.read("m.h").find("return x;"), std::string::npos);
}

TEST_F(Gnomonc, OutputsAreWrittenAllOrNone) {
  tree.file("a.frag", "void main() {}\n");
  tree.file("r.json", "older");
  tree.file("o.d", "older");
  EXPECT_EQ(run("build a.frag -o none/x --reflect r.json -MF o.d").code, 99);
  EXPECT_EQ(run("build a.frag -o /dev/full --reflect r.json -MF o.d").code, 99);
  EXPECT_EQ(tree.read("r.json") + tree.read("o.d"), "olderolder");
}

TEST_F(Gnomonc, StandardOutputIsWrittenBeforeFilesAreReplaced) {
  tree.file("a.frag", "void main() {}\n");
  tree.file("r.json", "older");
  EXPECT_EQ(run("--version > version.txt; { '" GNOMONC "' build a.frag --reflect r.json >/dev/full; }").code,
            99);
  EXPECT_EQ(tree.read("r.json"), "older");
}

TEST_F(Gnomonc, ADashIsStandardOutput) {
  tree.file("a.frag", "void main() {}\n");
  EXPECT_EQ(run("build a.frag -o -").out, "#version 450 core\nvoid main() {}\n");
  EXPECT_NE(run("build a.frag -o out.glsl --reflect -").out.find("\"stages\""), std::string::npos);
  EXPECT_EQ(run("build a.frag --reflect -").code, 2);
  EXPECT_EQ(run("build a.frag -o - -MD").code, 2);
  EXPECT_EQ(run("build a.frag -o - --target vulkan").code, 2);
  tree.file("m.glsl", "float f() { return 1.0f; }\n");
  EXPECT_NE(run("cpp m.glsl -o -").out.find("float f() const"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(tree.path("-")));
  for (const char* name : {"int", "class", "_X", "a__b", "1a", "std"})
    EXPECT_EQ(run("cpp m.glsl --name " + std::string(name)).code, 2) << name;
}

TEST_F(Gnomonc, TemporaryFilesAreNobodyElses) {
  tree.file("a.frag", "void main() {}\n");
  tree.file("private", "older");
  // Under the name that a process could foresee lies a link that waits for it.
  const Outcome built = run("--version > version.txt; sh -c 'ln -s private out.glsl.$$.tmp; exec \"" GNOMONC
                            "\" build a.frag -o out.glsl'");
  EXPECT_EQ(built.code, 0);
  EXPECT_EQ(tree.read("private"), "older");
  EXPECT_EQ(tree.read("out.glsl"), "#version 450 core\nvoid main() {}\n");
}

TEST_F(Gnomonc, AFileThatMayNotGrowIsNinetyNine) {
  tree.file("a.frag", "//" + std::string(100000, 'x') + "\nvoid main() {}\n");
  const Outcome built = run("--version > version.txt; ulimit -f 2; '" GNOMONC "' build a.frag -o out.glsl");
  EXPECT_EQ(built.code, 99) << built.err;
  EXPECT_FALSE(std::filesystem::exists(tree.path("out.glsl")));
}

TEST_F(Gnomonc, IgnoredInterruptsStayIgnored) {
  // Enough to be still at work when the signal comes.
  std::string functions;
  for (int i = 0; i < 1500; ++i) functions += "float f" + std::to_string(i) + "(float x) { return x; }\n";
  tree.file("m.glsl", functions);
  const std::string start = "--version > version.txt; sh -c '";
  const std::string rest =
      " \"" GNOMONC "\" check m.glsl --target vulkan & pid=$!; sleep 0.1; kill -HUP $pid; wait $pid'";
  EXPECT_EQ(run(start + "trap \"\" HUP;" + rest).code, 0);
  EXPECT_EQ(run(start + rest).code, 130);
}

TEST_F(Gnomonc, LineBreaksInNamesAreRefused) {
  tree.file("a.frag", "void main() {}\n");
  const Outcome built = run("--version > version.txt; \"" GNOMONC "\" build a.frag -MD -o 'a\nb'");
  EXPECT_EQ(built.code, 2);
  EXPECT_EQ(built.err, "a?b: error: has a line break, shown as ?, in its name: rename it\n");
}

TEST_F(Gnomonc, DescriptorsAreWrittenToAndModesStay) {
  tree.file("a.frag", "void main() {}\n");
  const Outcome appended =
      run("--version > version.txt; { echo before; '" GNOMONC "' build a.frag -o /dev/stdout; echo after; }");
  EXPECT_EQ(appended.out, "before\n#version 450 core\nvoid main() {}\nafter\n");
  tree.file("out.glsl", "older");
  std::filesystem::permissions(tree.path("out.glsl"), std::filesystem::perms{0640});
  EXPECT_EQ(run("build a.frag -o out.glsl").code, 0);
  EXPECT_EQ(std::filesystem::status(tree.path("out.glsl")).permissions(), std::filesystem::perms{0640});
  std::filesystem::create_symlink("later.glsl", tree.path("link.glsl"));
  EXPECT_EQ(run("build a.frag -o link.glsl").code, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(tree.path("link.glsl")));
  EXPECT_EQ(tree.read("later.glsl"), "#version 450 core\nvoid main() {}\n");
  std::filesystem::create_symlink("round.glsl", tree.path("round.glsl"));
  EXPECT_EQ(run("build a.frag -o round.glsl").code, 99);
}

TEST_F(Gnomonc, WhatIsNoOrdinaryFileIsRefusedAtOnce) {
  EXPECT_EQ(
      run("--version > version.txt; mkfifo pipe; timeout 20 '" GNOMONC "' build pipe --stage frag").code, 2);
  const Outcome device = run("build /dev/zero --stage frag");
  EXPECT_EQ(device.code, 2);
  EXPECT_TRUE(device.err.starts_with("/dev/zero: error: is no regular file")) << device.err;
}

TEST_F(Gnomonc, UsageThatIsNearlyRight) {
  tree.file("a.frag", "void main() {}\n");
  EXPECT_NE(run("build a.frag --tagret vulkan").err.find("--tagret"), std::string::npos);
  EXPECT_EQ(run("build a.frag b.frag").err, "error: one FILE at a time, got 2: a.frag, b.frag\n");
  for (const char* wrong :
       {"-o ''", "--reflect ''", "-MF '' -o x", "-D X=1 -D X=2", "--name x", "--embed vulkan"})
    EXPECT_EQ(run("build a.frag " + std::string(wrong)).code, 2) << wrong;
  EXPECT_EQ(run("build a.frag -D X=1 -D X=1").code, 0);
}

TEST_F(Gnomonc, IncludeFolders) {
  tree.file("a.frag", "#include <x.glsl>\nvoid main() { x(); }\n");
  tree.file("one/x.glsl", "void x() {}\n");
  EXPECT_EQ(run("build a.frag").code, 1);
  EXPECT_EQ(run("build -I none -I one a.frag").code, 0);
}

TEST_F(Gnomonc, CheckTakesEveryFileAndTheWorstCode) {
  tree.file("good.glsl", "float f(float x) { return x; }\n");
  tree.file("bad.glsl", "float f(float x) { return y; }\n");
  tree.file("loop.glsl", "void f() { while (true) {} }\n");
  EXPECT_EQ(run("check good.glsl").code, 0);
  const Outcome mixed = run("check bad.glsl good.glsl loop.glsl");
  EXPECT_EQ(mixed.code, 1);
  EXPECT_NE(mixed.err.find("bad.glsl:1: error: 'y': undeclared identifier\n"), std::string::npos);
  EXPECT_NE(mixed.err.find("loop.glsl:1: warning: loop without a bound"), std::string::npos);
  EXPECT_EQ(run("check bad.glsl none.glsl").code, 2);
  EXPECT_EQ(run("build good.glsl --stage frag").code, 2);
}

TEST_F(Gnomonc, LibraryIsFoundWithoutOptions) {
  const Outcome listed = run("list");
  EXPECT_EQ(listed.code, 0);
  EXPECT_NE(listed.out.find("core/portable "), std::string::npos);
  EXPECT_EQ(listed.out.find("programs/"), std::string::npos);
  tree.file("m.glsl", "#include <gnomon/core/portable.glsl>\nvoid f(GNOMON_OUT(float) x) { x = 1.0f; }\n");
  EXPECT_EQ(run("check m.glsl").code, 0);
}

TEST_F(Gnomonc, DepfileNamesWhatWasRead) {
  tree.file("a.frag", "#include \"b.glsl\"\nvoid main() {}\n");
  tree.file("b.glsl", "float b;\n");
  EXPECT_EQ(run("build a.frag -MD -o out").code, 0);
  EXPECT_EQ(tree.read("out.d"), "out: \\\n  a.frag \\\n  b.glsl\nb.glsl:\n");
  EXPECT_EQ(run("build a.frag -MF my.d -o out").code, 0);
  EXPECT_EQ(run("build a.frag -MD -MFsame.d -o out").code, 0);
  EXPECT_EQ(tree.read("my.d"), tree.read("out.d"));
  EXPECT_EQ(tree.read("same.d"), tree.read("out.d"));
}

TEST_F(Gnomonc, DepfileOfAFailureNamesWhatWasReadToo) {
  tree.file("a.frag", "#include \"b.glsl\"\n#include \"c.glsl\"\nvoid main() {}\n");
  tree.file("b.glsl", "float b = x;\n");
  tree.file("out", "older");
  EXPECT_EQ(run("build a.frag -MD -o out").code, 1);
  EXPECT_EQ(tree.read("out.d"), "out: \\\n  a.frag \\\n  b.glsl \\\n  c.glsl\nb.glsl:\nc.glsl:\n");
  tree.file("c.glsl", "float c;\n");
  EXPECT_EQ(run("build a.frag -MD -o out").code, 1);
  EXPECT_EQ(tree.read("out"), "older");
}

TEST_F(Gnomonc, DepfileThatCannotBeWritten) {
  tree.file("a.frag", "void main() {}\n");
  for (const std::string arguments : {"-MD", "-MF x", "-o out -MF", "-o out -MF out", "-o out -MF a.frag"}) {
    EXPECT_EQ(run("build a.frag " + arguments).code, 2) << arguments;
    EXPECT_EQ(tree.read("out"), "") << arguments;
  }
  EXPECT_EQ(run("build a.frag -o out -MF none/x").code, 99);
  EXPECT_EQ(tree.read("out"), "");
  EXPECT_EQ(tree.read("a.frag"), "void main() {}\n");
}

TEST_F(Gnomonc, GraphNamesEveryFile) {
  tree.file("a.frag", "#include \"b.glsl\"\nno shader at all\n");
  tree.file("b.glsl", "float b;\n");
  EXPECT_EQ(run("graph a.frag").out, "a.frag\n  b.glsl\n");
  EXPECT_NE(run("graph --dot a.frag").out.find("\"a.frag\" -> \"b.glsl\";"), std::string::npos);
  EXPECT_EQ(run("graph none.frag").code, 2);
  tree.file("b.glsl", "#include \"a.frag\"\n");
  EXPECT_EQ(run("graph a.frag").code, 1);
}

TEST_F(Gnomonc, HelpAndVersion) {
  EXPECT_EQ(run("--version").out.rfind("gnomonc ", 0), 0u);
  EXPECT_NE(run("--help").out.find("build"), std::string::npos);
  EXPECT_EQ(run("--help").code, 0);
  EXPECT_NE(run("build --help").out.find("glsl450"), std::string::npos);
}

}  // namespace
}  // namespace gnomon
