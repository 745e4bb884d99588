# Writes templates.cpp, which holds the files under templates/ as text: `matpoint new_plugin` then
# needs nothing but the executable.
file(GLOB_RECURSE template_files CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/templates
     ${CMAKE_CURRENT_SOURCE_DIR}/templates/*)
set(text "#include \"templates.hpp\"\n\nnamespace matpoint {\n\nstd::span<const TemplateFile> template_files() {\n")
string(APPEND text "    static constexpr TemplateFile files[] = {\n")
foreach(path IN LISTS template_files)
  file(READ templates/${path} content)
  string(APPEND text "{\"${path}\", R\"~template~(${content})~template~\"},\n")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS templates/${path})
endforeach()
string(APPEND text "    };\n    return files;\n}\n\n}  // namespace matpoint\n")
file(CONFIGURE OUTPUT templates.cpp CONTENT "${text}" @ONLY)
