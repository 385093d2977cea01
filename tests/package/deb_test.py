#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The packages that `cpack` makes of this build.

Together they hold what `cmake --install` installs, at Debian's places, each file in the package that it belongs to; they
name what they need; two runs give the same bytes; lintian, where it is installed, has nothing to say. What they do on a
bare Debian is tried by deb.sh."""
import argparse
import os
import pathlib
import re
import shutil
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from checks import check, finish, run  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent


def pack(build, folder):
    """Quickly: gzip takes a fifth of the time of xz."""
    done = run("cpack", "--config", build / "CPackConfig.cmake", "-B", folder, "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=gzip",
               cwd=folder, env={**os.environ, "SOURCE_DATE_EPOCH": "1700000000"})
    if done.returncode:
        print(done.stdout + done.stderr)
        sys.exit("cpack failed")
    return {path.name.split("_")[0]: path for path in folder.glob("*.deb")}


def files_of(package):
    """Its files without the leading ./, and links; each must be root's, and readable by all."""
    names = set()
    for line in run("dpkg-deb", "-c", package).stdout.splitlines():
        mode, owner, size, _, _, name = line.split(None, 5)
        check(owner == "root/root", f"{name} is {owner}'s")
        check(mode in ("drwxr-xr-x", "-rwxr-xr-x", "-rw-r--r--", "lrwxrwxrwx"), f"{name}: {mode}")
        check(not (mode == "-rwxr-xr-x" and int(size) == 0), f"{name} is empty")
        if mode[0] != "d":
            names.add(name.split(" -> ")[0].removeprefix("./"))
    return names


def at_debian_place(name):
    """Where an installed file should be; None: nowhere."""
    if name == "share/doc/tetproof/LICENSE":
        return None
    if re.match(r"share/man/man\d/|share/doc/tetproof/CHANGELOG.md$", name):
        name += ".gz"
    name = re.sub(r"^lib/python3\.\d+/", "lib/python3/", name)
    return "usr/" + name.replace("share/zsh/site-functions/", "share/zsh/vendor-completions/")


def check_layout(folder):
    """On a made-up tree: what goes where, and what refuses."""
    staged = folder / "staged"
    runtime = ["bin/tetproof-verify", "lib/libx.so.0", "lib/python3.11/dist-packages/x/core.cpython-311-x86_64-linux-gnu.so"]
    dev = ["include/x.h", "lib/libx.a", "lib/libx.so", "lib/pkgconfig/x.pc", "lib/cmake/x/xConfig.cmake"]
    both = [*runtime, *dev, "share/doc/tetproof/LICENSE", "share/doc/tetproof/CHANGELOG.md"]
    for name in both:
        path = staged / "tetproof" / "usr" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if name == "lib/libx.so":
            path.symlink_to("libx.so.0")
        else:
            path.write_text("text")
    source = HERE.parents[1]
    script = folder / "layout.cmake"
    script.write_text(f"""set(CPACK_TEMPORARY_INSTALL_DIRECTORY "{staged}")
set(CPACK_TETPROOF_SOURCE "{source}")
include("{source}/.cmake/debian/layout.cmake")
message("${{CPACK_DEBIAN_TETPROOF_PACKAGE_DEPENDS}}, recommends ${{CPACK_DEBIAN_TETPROOF_PACKAGE_RECOMMENDS}}")
""")
    (staged / "tetproof" / "usr" / runtime[0]).write_text("")
    done = run("cmake", "-P", script)  # as if it were just being linked
    check(done.returncode != 0 and "is empty" in done.stderr, f"an empty program is packed: {done.stderr}")
    (staged / "tetproof" / "usr" / runtime[0]).write_text("text")
    done = run("cmake", "-P", script)
    check(done.returncode == 0 and "python3 (>= 3.11~), python3 (<< 3.12~), recommends python3-numpy" in done.stderr,
          f"a module for Python 3.11: {done.stderr}")
    for package, expected in (("tetproof", runtime), ("dev", dev)):
        found = {str(path.relative_to(staged / package / "usr")) for path in (staged / package / "usr").rglob("*")
                 if not path.is_dir()}
        found = {name for name in found if not re.match("share/(doc|lintian)/", name)}
        expected = [name.replace("python3.11", "python3") for name in expected]
        check(found == set(expected), f"{package} holds {sorted(found)}, expected {sorted(expected)}")
    check(not (staged / "tetproof" / "usr" / "include").exists(), "an empty folder stays")
    check((folder / "control" / "shlibs").read_text().startswith("libx 0 tetproof (= "), "what needs libx.so.0 needs tetproof")
    check((folder / "control" / "triggers").read_text() == "activate-noawait ldconfig\n", "the loader is told of libx.so.0")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    parser.add_argument("--installed", required=True, type=pathlib.Path, help="what cmake --install installs")
    arguments = parser.parse_args()
    for tool in ("cpack", "dpkg-deb", "dpkg-shlibdeps", "file"):
        if not shutil.which(tool):
            print(f"skipped: {tool} is not installed")
            sys.exit(77)
    # Such programs are ten times as large, and nobody packs them.
    if re.search(r"^TETPROOF_SANITIZE:\w+=.", (arguments.build / "CMakeCache.txt").read_text(), re.MULTILINE):
        print("skipped: the build has sanitizers")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as temporary:
        folders = [pathlib.Path(temporary) / name for name in ("first", "second")]
        for folder in folders:
            folder.mkdir()
        packages, again = (pack(arguments.build.resolve(), folder) for folder in folders)
        check(set(packages) == {"tetproof", "tetproof-dev"}, f"packages: {packages}")
        for name, path in packages.items():
            check(path.read_bytes() == again[name].read_bytes(), f"{name}: two runs give other bytes")
        runtime, dev = (files_of(packages[name]) for name in ("tetproof", "tetproof-dev"))
        check(not runtime & dev, f"in both: {runtime & dev}")
        installed = {str(path.relative_to(arguments.installed)) for path in arguments.installed.rglob("*") if not path.is_dir()}
        wanted = {at_debian_place(name) for name in installed} - {None}
        extra = {f"usr/share/doc/{name}/{file}" for name in packages for file in ("changelog.gz", "copyright")}
        # What lintian is told of a shared library and of pkg-config's file comes with them.
        extra |= {name for name in runtime | dev if name.startswith("usr/share/lintian/overrides/")}
        check(runtime | dev == wanted | extra, f"packed and installed differ: {sorted((runtime | dev) ^ (wanted | extra))}")
        for name in runtime:
            check(not re.search(r"^usr/include/|\.a$|/cmake/|/pkgconfig/", name), f"{name} belongs into tetproof-dev")
        for name in dev:
            check(not re.search(r"^usr/bin/|^usr/libexec/|/man1/|/dist-packages/", name), f"{name} belongs into tetproof")
        depends, depends_dev = (run("dpkg-deb", "-f", packages[name], "Depends").stdout for name in ("tetproof", "tetproof-dev"))
        version = run("dpkg-deb", "-f", packages["tetproof"], "Version").stdout.strip()
        recommends = run("dpkg-deb", "-f", packages["tetproof"], "Recommends").stdout
        # Gmsh's library is nearly all of what would be downloaded, and one helper needs it.
        check("libgmsh" in recommends, f"libgmsh is not among what tetproof recommends: {recommends}")
        check("libgmsh" not in depends, f"tetproof depends on libgmsh: {depends}")
        for library in ("libc6", "libtbb12", "libfmt", "libgmp10", "libmpfr6", "libpugixml1"):
            check(library in depends, f"{library} is not among what tetproof depends on: {depends}")
        check(f"tetproof (= {version})" in depends_dev, f"tetproof-dev depends on {depends_dev}")
        for library in ("libeigen3-dev", "libfmt-dev", "libtbb-dev", "libgmp-dev", "libmpfr-dev", "libpugixml-dev"):
            check(library in depends_dev, f"{library} is not among what tetproof-dev depends on: {depends_dev}")
        if shutil.which("lintian"):
            said = run("lintian", "--fail-on", "error,warning", *packages.values(), env={**os.environ, "LC_ALL": "C.UTF-8"})
            check(said.returncode == 0, f"lintian: {said.stdout}")
        else:
            print("not checked with lintian, which is not installed")
        check_layout(pathlib.Path(temporary))
    finish()


if __name__ == "__main__":
    main()
