#include "report/text_file.hpp"

#include <matpoint/output_file.hpp>

namespace matpoint {

void write_text(const std::filesystem::path& file, const std::string& text) {
    OutputFile out(file);
    out.write(text);
    out.commit();
}

}  // namespace matpoint
