"""Plugins as users write them (user_plugins/), built against an installation as users do."""
from runs import ROOT, call

SOURCES = ROOT / "tests/benchmarks/user_plugins"
MATERIALS = {"plain": "plain_rubber", "by hand": "lanes_rubber", "scalar": "scalar_rubber", "idle": "idle_rubber"}


def build_plugins(program, instruction_set, folder):
    """Makes the plugins in `folder`, for the instruction set; `program` is bin/matpoint of a build tree or of an
    installation. Returns the folder that they are in."""
    sdk = program.resolve().parents[1]
    if (sdk / "CMakeCache.txt").exists():
        call(["cmake", "--install", sdk, "--prefix", folder / "sdk"])
        sdk = folder / "sdk"
    known = instruction_set if (sdk / "lib/glibc-hwcaps" / instruction_set).is_dir() else "native"
    call(["cmake", "-S", SOURCES, "-B", folder / "build", "-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_PREFIX_PATH={sdk}",
          f"-DMATPOINT_INSTRUCTION_SETS={known}"])
    call(["cmake", "--build", folder / "build", "--parallel", "2"])
    return folder / "build/plugins"


def variants(plugins):
    """By name, the values that put one of the plugins into block_quadratic.json in place of the built-in component."""
    def with_plugin(name, values):
        return {"/plugins": [str(plugins / f"{name}.so")]} | values

    return {"spline": with_plugin("user_spline", {"/shape_function": {"type": "user_spline"}})} | {
        name: with_plugin(plugin, {"/materials/rubber/type": plugin}) for name, plugin in MATERIALS.items()}
