#include "components.hpp"
#include "options.hpp"
#include "verbs.hpp"

#include "config/json_schema.hpp"

#include <iostream>

namespace matpoint {

int schema(const std::vector<std::string>& arguments) {
    const VerbOptions verb{
        .usage = "matpoint schema",
        .doc =
            "Prints a JSON Schema of scenes with all components there are. An editor that knows\n"
            "it (\"$schema\" in a scene) completes names and marks mistakes."};
    if (!parse(verb, arguments)) return exit_done;
    AllComponents components;
    std::cout << json_schema(components).dump(2) << "\n";
    return components.exit_status();
}

}  // namespace matpoint
