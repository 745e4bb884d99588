#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace matpoint {

/// Text between tags or within an attribute's quotes of XML, SVG and HTML.
std::string escaped(std::string_view text);

/// At most `length` characters (UTF-8) of a text; the last is "…" if some are left out.
std::string shortened(const std::string& text, std::size_t length);

/// How many characters (UTF-8) a text has.
std::size_t length_of(std::string_view text);

/// A number as SVG text, 2·10⁻⁵ with a raised exponent where it is far from one.
std::string number_markup(double value, int digits);

/// 10 to a whole power as SVG text.
std::string power_markup(int exponent);

/// A picture of so many pixels on white, with its title in bold.
std::string svg_document(const std::string& title, double width, double height, const std::string& body);

}  // namespace matpoint
