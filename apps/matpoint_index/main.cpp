// Writes the index file of a plugin beside its library: matpoint_index LIBRARY. The CMake function
// matpoint_add_plugin calls it after each build, so a plugin that can't be opened fails to build.

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>

#include "registry/plugin_index.hpp"
#include "registry/plugin_library.hpp"

int main(int count, char** arguments) {
    if (count != 2) {
        std::fputs("usage: matpoint_index LIBRARY\n", stderr);
        return 2;
    }
    try {
        const std::filesystem::path file = matpoint::index_file_of(arguments[1]);
        const matpoint::Json index = matpoint::index_of(matpoint::PluginLibrary(arguments[1]));
        // Renamed when complete: a run that starts meanwhile reads the old index or the new one.
        const std::filesystem::path complete = file.string() + ".new";
        std::ofstream stream(complete);
        stream.exceptions(std::ios::failbit | std::ios::badbit);
        stream << index.dump(2) << '\n';
        stream.close();
        std::filesystem::rename(complete, file);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "matpoint_index: %s\n", error.what());
        return 3;
    }
}
