"""Commands as a person types them: into one shell, in a fresh copy of the
repository in which plsc has just been built; and the recipes for CI.
"""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile

# Between the outputs of commands.
MARK = "\n--- 8< --- typed.py ---\n"


def copy_repository(repository, plsc, target):
    """What a clone has, and the program where the quickstart builds it."""
    names = subprocess.run(["git", "ls-files", "-z", "README.md", "docs", "examples", ".ci"],
                           cwd=repository, capture_output=True, text=True)
    files = names.stdout.split("\0")[:-1] if names.returncode == 0 else [
        str(path.relative_to(repository)) for top in ("README.md", "docs", "examples", ".ci")
        for path in [repository / top, *(repository / top).rglob("*")] if path.is_file()]
    for name in files:
        if not (repository / name).exists():  # deleted, and not committed yet
            continue
        (target / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(repository / name, target / name)
    built = target / "build/release/runtime/cli"
    built.mkdir(parents=True)
    (built / "plsc").symlink_to(plsc)


def environment():
    """Without a plsc that the shell would find by itself."""
    folders = [folder for folder in os.environ["PATH"].split(":")
               if folder and not (pathlib.Path(folder) / "plsc").exists()]
    return dict(os.environ, PATH=":".join(folders))


def run(commands, plsc, repository):
    """The outputs of the commands, typed one after the other."""
    with tempfile.TemporaryDirectory() as folder:
        copy_repository(repository, plsc, pathlib.Path(folder))
        script = "exec 2>&1\n" + "".join(
            f"{command}\nprintf '%s' '{MARK}'\n" for command in commands)
        done = subprocess.run(["bash", "-c", script], cwd=folder, env=environment(), text=True,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE)
        return done.stdout.split(MARK)[:len(commands)]


def recipes(repository):
    """{name: [steps]} of the CI recipes in docs/testing-robots.md."""
    text = (repository / "docs/testing-robots.md").read_text()
    found = {}
    for block in re.findall(r"^```yaml\n(.*?)^```", text, re.M | re.S):
        if "runs-on:" in block:
            steps = re.findall(r"^      - run: (?:\|\n((?:          .*\n)+)|(.*)\n)", block, re.M)
            found["GitHub"] = [re.sub(r"^ +", "", one, flags=re.M).strip()
                               for steps_of in steps for one in steps_of if one]
        elif "script:" in block:
            script = re.search(r"^  script:\n((?:    .*\n)+)", block, re.M)[1]
            found["GitLab"] = [" ".join(one.split()) for one in re.split(r"^    - ", script, flags=re.M)[1:]]
    return found


def broken_recipes(plsc, repository):
    """What is wrong with them, without a bare system (ci_recipes_chroot.sh)."""
    found = recipes(repository)
    if sorted(found) != ["GitHub", "GitLab"]:
        yield f"docs/testing-robots.md has recipes for {sorted(found)}"
    for name, commands in found.items():
        script = "\n".join(commands)
        # The packages are those of .ci/setup.sh, and no list of its own that
        # can fall behind.
        for needed in (". .ci/setup.sh", "plsc_install $PLSC_BUILD_PACKAGES"):
            if needed not in script:
                yield f"the recipe for {name} lacks '{needed}'"
        own = re.findall(r"\b(?:lib\S+-dev|cmake ninja\S*)", script)
        if own:
            yield f"the recipe for {name} names packages itself: {own}"
        if subprocess.run(["sh", "-n", "-c", script]).returncode:
            yield f"the recipe for {name} is no shell script"
        with tempfile.TemporaryDirectory() as folder:
            shutil.copytree(repository / "examples", pathlib.Path(folder) / "robots")
            for command in commands:
                if not command.startswith("/opt/plsc/"):
                    continue
                typed = re.sub(r"^/opt/plsc/\S+", str(plsc), command)
                done = subprocess.run(["sh", "-ec", typed], cwd=folder, text=True,
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
                if done.returncode:
                    yield f"{name}: $ {command}\n{done.stdout}"


if __name__ == "__main__":
    import sys
    name = sys.argv[1]
    for step in recipes(pathlib.Path(__file__).resolve().parents[2])[name]:
        # GitHub begins each step in the project's folder.
        print(step if name == "GitLab" else f'(\ncd "$CI_PROJECT_DIR"\n{step}\n)')
