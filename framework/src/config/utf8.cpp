#include "config/utf8.hpp"

#include <matpoint/schema.hpp>

namespace matpoint {

std::string as_utf8(const std::string& text) {
    return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
}

}  // namespace matpoint
