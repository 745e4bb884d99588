#include "report/markup.hpp"

#include <matpoint/output_file.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace matpoint {
namespace {

bool begins_character(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
}

std::string with_minus_sign(std::string number) {
    for (std::size_t at = 0; (at = number.find('-', at)) != number.npos;) number.replace(at, 1, "−");
    return number;
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            case '\'':
                result += "&#39;";
                break;
            default:
                // XML has no way to write other control characters.
                result += static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? ' ' : c;
        }
    }
    return result;
}

std::size_t length_of(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins_character));
}

std::string shortened(const std::string& text, std::size_t length) {
    if (length_of(text) <= length) return text;
    std::size_t end = 0;
    for (std::size_t kept = 0; end < text.size(); ++end) {
        if (begins_character(text[end]) && kept++ == length - 1) break;
    }
    return text.substr(0, end) + "…";
}

std::string power_markup(int exponent) {
    return fmt::format("10<tspan dy=\"-5\" font-size=\"9\">{}</tspan>",
                       with_minus_sign(fmt::to_string(exponent)));
}

std::string number_markup(double value, int digits) {
    const std::string text = number_text(value, digits);
    const std::size_t e = text.find('e');
    if (e == text.npos) return with_minus_sign(text);
    const std::string mantissa = text.substr(0, e);
    const std::string power = power_markup(std::stoi(text.substr(e + 1)));
    return mantissa == "1" ? power : with_minus_sign(mantissa) + "·" + power;
}

std::string svg_document(const std::string& title, double width, double height, const std::string& body) {
    const double length = static_cast<double>(std::max<std::size_t>(length_of(title), 1));
    const double font = std::clamp((width - 32) / (0.66 * length), 11.0, 16.0);
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"system-ui, 'DejaVu Sans', Arial, sans-serif\" "
        "font-size=\"12\" role=\"img\">\n"
        "<title>{2}</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
        "<text x=\"16\" y=\"27\" font-size=\"{5:.1f}\" font-weight=\"bold\">{3}</text>\n{4}</svg>\n",
        width, height, escaped(title), escaped(shortened(title, static_cast<std::size_t>(width / 7.5))), body,
        font);
}

}  // namespace matpoint
