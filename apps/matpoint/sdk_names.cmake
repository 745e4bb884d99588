# Writes OUTPUT, which holds the names of the SDK's classes, from its headers in the folder SDK: a plugin's class
# can't be called like one of them.
file(GLOB headers ${SDK}/*.hpp)
set(names)
foreach(header IN LISTS headers)
  file(READ ${header} text)
  string(REGEX MATCHALL "\n(class|struct|enum class|concept|using) [A-Z][A-Za-z0-9]*" declarations "${text}")
  foreach(declaration IN LISTS declarations)
    string(REGEX REPLACE ".* " "" name "${declaration}")
    list(APPEND names ${name})
  endforeach()
endforeach()
list(REMOVE_DUPLICATES names)
list(SORT names)
list(JOIN names "\", \"" names)
file(WRITE ${OUTPUT} "#include \"templates.hpp\"

namespace matpoint {

std::span<const std::string_view> sdk_names() {
    static constexpr std::string_view names[] = {\"${names}\"};
    return names;
}

}  // namespace matpoint
")
