#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Installs gnomon, moves the installation, and builds tests/consumer with it, as a stranger would.

Usage: consumer_test.py BUILD_DIRECTORY CMAKE CXX

With Ninja and with Make: a build without a change runs nothing; a touched include rebuilds exactly the shaders whose
`gnomonc graph` names it; an error in an include is reported at its line and mended there. Then the same program by
pkg-config and a hand-written Makefile. Exit code 1 and the reason at the first thing that does not hold.
"""
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
BUILD, CMAKE, CXX = Path(sys.argv[1]), sys.argv[2], sys.argv[3]
SOURCES = ["hill.frag", "flat.frag", "quad.vert"]
COMPILING = "Compiling shader"


def expect(holds, text):
    if not holds:
        sys.exit(f"consumer_test: {text}")


def run(*words, fails=False, **options):
    """Standard output and error together; the exit code has to be as expected."""
    words = [str(word) for word in words]
    done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)
    expect((done.returncode != 0) == fails, f"{' '.join(words)} ended with {done.returncode}:\n{done.stdout}")
    return done.stdout


def install(folder):
    """An installation that was moved after it was made."""
    run(CMAKE, "--install", BUILD, "--prefix", folder / "first")
    prefix = folder / "elsewhere" / "moved"
    prefix.parent.mkdir()
    shutil.move(folder / "first", prefix)
    return prefix


def check_programs(prefix):
    library = prefix / "share" / "gnomon"
    listed = run(prefix / "bin" / "gnomonc", "list")
    expect("relief/multilevel" in listed, f"gnomonc list does not find the installed library:\n{listed}")
    told = run(prefix / "bin" / "gnomon", "info")
    expect(str(library) in told, f"gnomon info does not name {library}:\n{told}")
    program = library / "programs" / "multilevel.frag"
    graph = run(prefix / "bin" / "gnomonc", "graph", program).splitlines()
    expect(all(Path(line.strip()).is_relative_to(library) for line in graph), "an include lies outside of the prefix")
    strays = [path for path in library.rglob("*") if path.suffix in (".cpp", ".h", ".txt")]
    expect(not strays, f"the installed library has files that are no shaders: {strays}")


def check_components(folder, prefix):
    script = folder / "find.cmake"
    script.write_text("find_package(gnomon CONFIG REQUIRED COMPONENTS bogus)\n")
    said = run(CMAKE, f"-DCMAKE_PREFIX_PATH={prefix}", "-P", script, fails=True)
    expect('gnomon has no component "bogus": it has compiler, shaders, tools.' in " ".join(said.split()),
           f"an unknown component is not named:\n{said}")
    shutil.copytree(prefix, folder / "partly")
    next((folder / "partly").rglob("gnomon_compiler.cmake")).unlink()
    script.write_text("find_package(gnomon CONFIG REQUIRED COMPONENTS compiler)\n")
    said = run(CMAKE, f"-DCMAKE_PREFIX_PATH={folder / 'partly'}", "-P", script, fails=True)
    expect("--component compiler" in said, f"a component that is not installed is not named:\n{said}")


def check_arguments(folder, prefix):
    """STAGE for a source whose extension tells none; a target of another folder is refused."""
    project = folder / "arguments"
    (project / "below").mkdir(parents=True)
    (project / "tint.glsl").write_text("out vec4 color;\nvoid main() { color = vec4(1.0); }\n")
    text = ("cmake_minimum_required(VERSION 3.25)\nproject(arguments LANGUAGES NONE)\n"
            "find_package(gnomon CONFIG REQUIRED COMPONENTS shaders tools)\nadd_custom_target(files ALL)\n"
            "gnomon_add_shaders(TARGET files SOURCES tint.glsl TARGETS essl300 STAGE {stage})\n")
    configure = (CMAKE, "-S", project, "-B", project / "build", f"-DCMAKE_PREFIX_PATH={prefix}")
    (project / "CMakeLists.txt").write_text(text.format(stage="frag"))
    run(*configure)
    run(CMAKE, "--build", project / "build")
    expect(list((project / "build").rglob("tint.glsl.essl300.glsl")), "STAGE makes no output")
    (project / "CMakeLists.txt").write_text(text.format(stage="fragment"))
    expect('unknown STAGE "fragment"' in run(*configure, fails=True), "a wrong STAGE is not named")
    (project / "CMakeLists.txt").write_text(text.format(stage="frag") + "add_subdirectory(below)\n")
    (project / "below" / "CMakeLists.txt").write_text(
        "gnomon_add_shaders(TARGET files SOURCES ../tint.glsl TARGETS vulkan STAGE frag)\n")
    said = " ".join(run(*configure, fails=True).split())
    expect(f'the target "files" belongs to {project}' in said, f"a target of another folder is not refused:\n{said}")


class Project:
    """A copy of the consumer, built with one generator."""

    def __init__(self, folder, prefix, generator):
        self.prefix, self.generator = prefix, generator
        self.source = folder / f"the project, {generator}"  # blanks and a comma have to work
        self.binary = self.source / "build"
        shutil.copytree(HERE / "consumer", self.source)

    def configure(self, *options):
        return run(CMAKE, "-G", self.generator, "-S", self.source, "-B", self.binary, f"-DCMAKE_CXX_COMPILER={CXX}",
                   f"-DCMAKE_PREFIX_PATH={self.prefix}", *options)

    def build(self, target="all", fails=False):
        return run(CMAKE, "--build", self.binary, "-j2", "--target", target, fails=fails)

    def start(self):
        run(self.binary / "consumer", self.source / "shaders", self.prefix / "share" / "gnomon")
        run(self.binary / "modules")

    def times(self):
        outputs = (self.binary / "outputs.txt").read_text().split("\n")[:-1]
        expect(len(outputs) == 9, f"GNOMON_SHADERS lists {outputs}")
        return {Path(output).name: os.stat(output).st_mtime_ns for output in outputs}

    def expect_rebuilt(self, cause, sources, target="all"):
        """A build after `cause` renews every output of these sources and no other; `shader_files` makes no headers."""
        before = self.times()
        self.build(target)
        renewed = {name for name, time in self.times().items() if time != before[name]}
        expected = {name for name in before if name.startswith(tuple(sources))
                    and not (target == "shader_files" and name.endswith(".h"))}
        expect(renewed == expected, f"after {cause}, {sorted(renewed)} were rebuilt instead of {sorted(expected)}")

    def graphs(self):
        """Source -> the files that it includes."""
        gnomonc, folder = self.prefix / "bin" / "gnomonc", self.source / "shaders"
        graphs = {}
        for source in SOURCES:
            text = run(gnomonc, "graph", folder / source, "-I", folder)
            graphs[source] = {line.strip() for line in text.splitlines()[1:]}
        return graphs


def check_unchanged(project):
    before = project.times()
    said = project.build()
    if project.generator == "Ninja":
        expect("no work to do" in said, f"ninja works without a change:\n{said}")
    expect(COMPILING not in said and "Building" not in said, f"a build without a change runs commands:\n{said}")
    expect(project.times() == before, "a build without a change renews outputs")


def check_touched(project):
    graphs = project.graphs()
    for include in sorted(set().union(*graphs.values())):
        os.utime(include)
        users = {source for source in SOURCES if include in graphs[source]}
        project.expect_rebuilt(f"a touch of {include}", users, "shader_files")
    expect(graphs["hill.frag"] and graphs["flat.frag"] and not graphs["quad.vert"], f"not the graphs meant: {graphs}")
    os.utime(project.source / "shaders" / "quad.vert")
    project.expect_rebuilt("a touch of quad.vert", {"quad.vert"}, "shader_files")
    project.build()


def check_error(project):
    include = project.source / "shaders" / "common" / "light.glsl"
    whole, before = include.read_text(), project.times()
    include.write_text(whole.replace("dot(normal, u_to_sun)", "dot(normal, u_to_moon)"))
    line = 1 + next(n for n, text in enumerate(whole.split("\n")) if "dot(normal" in text)
    said = project.build(fails=True)
    expect(f"{include}:{line}: error: 'u_to_moon'" in said, f"the error is not located:\n{said}")
    expect(project.times() == before, "an error changes outputs")
    include.write_text(whole)
    project.expect_rebuilt("mending light.glsl", {"hill.frag"})


def check_cmake(folder, prefix, generator):
    project = Project(folder, prefix, generator)
    project.configure()
    project.build()
    project.start()
    check_unchanged(project)
    check_touched(project)
    check_error(project)
    before = project.times()
    project.configure("-DBLUE=0.25")
    project.build()
    expect(all(time != before[name] for name, time in project.times().items()), "other DEFINES rebuild too little")
    project.start()
    check_unchanged(project)


def check_make(folder, prefix):
    project = folder / "by-hand"
    shutil.copytree(HERE / "consumer", project)
    environment = dict(os.environ, PKG_CONFIG_PATH=str(next(prefix.rglob("pkgconfig"))), CXX=CXX)
    make = ("make", "-C", project)
    run(*make, env=environment)
    library = run("pkg-config", "--variable=shaderdir", "gnomon", env=environment).strip()
    run(project / "consumer", project / "shaders", library)
    run(*make, "-q", env=environment)
    os.utime(project / "shaders" / "common" / "light.glsl")
    would = run(*make, "-n", env=environment)
    expect("hill.frag.h" in would and "flat.frag.h" not in would, f"make does not follow the depfiles:\n{would}")


def main():
    with tempfile.TemporaryDirectory(prefix="gnomon-consumer-") as name:
        folder = Path(name).resolve()
        prefix = install(folder)
        check_programs(prefix)
        check_components(folder, prefix)
        check_arguments(folder, prefix)
        for generator in ("Ninja", "Unix Makefiles"):
            check_cmake(folder, prefix, generator)
        check_make(folder, prefix)


main()
