#include "config/document.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

namespace matpoint {
namespace {

std::string error_of(std::string_view text) {
    try {
        parse_document(text, "a.json");
    } catch (const InputError& e) {
        return e.what();
    }
    return "no error";
}

void expect_at(const Document& document, const std::string& pointer, int line, int column) {
    const auto found = document.positions.find(pointer);
    ASSERT_NE(found, document.positions.end()) << pointer;
    EXPECT_EQ(found->second.line, line) << pointer;
    EXPECT_EQ(found->second.column, column) << pointer;
}

TEST(document, knows_where_members_start) {
    const Document document =
        parse_document("{\n  \"a\": 1,\n  \"b\": {\"c\" : true, \"d\":-2.5e3}\n}", "a.json");
    expect_at(document, "", 1, 1);
    expect_at(document, "/a", 2, 3);
    expect_at(document, "/b", 3, 3);
    expect_at(document, "/b/c", 3, 9);
    expect_at(document, "/b/d", 3, 21);
    EXPECT_EQ(document.positions.size(), 5u);
}

TEST(document, knows_where_elements_of_nested_arrays_start) {
    const Document document = parse_document("[ [1,22 ,\n 333], {\"k\":[ \"x\" ]}, null,7]", "a.json");
    expect_at(document, "/0", 1, 3);
    expect_at(document, "/0/0", 1, 4);
    expect_at(document, "/0/1", 1, 6);
    expect_at(document, "/0/2", 2, 2);
    expect_at(document, "/1", 2, 8);
    expect_at(document, "/1/k", 2, 9);
    expect_at(document, "/1/k/0", 2, 15);
    expect_at(document, "/2", 2, 23);
    expect_at(document, "/3", 2, 28);
}

TEST(document, looks_past_comments_also_right_after_numbers) {
    const Document document = parse_document(
        "// \"z\": 1\n{ /* \"y\" */ \"a\":1/* , \"x\" */,\n// \"w\"\n  \"b\":[2// 3\n,/**/4]}", "a.json");
    expect_at(document, "", 2, 1);
    expect_at(document, "/a", 2, 13);
    expect_at(document, "/b", 4, 3);
    expect_at(document, "/b/0", 4, 8);
    expect_at(document, "/b/1", 5, 6);
    EXPECT_EQ(document.json, (Json{{"a", 1}, {"b", {2, 4}}}));
}

TEST(document, copes_with_escapes_in_keys) {
    const Document document =
        parse_document(R"({"a/b": {"~\"\\": [1]}, "\u00e9": 2, "x": "\"{,", "last": 3})", "a.json");
    expect_at(document, "/a~1b/~0\"\\/0", 1, 20);
    expect_at(document, "/\xC3\xA9", 1, 25);
    expect_at(document, "/last", 1, 51);
}

TEST(document, counts_characters_not_bytes) {
    const Document document =
        parse_document("\xEF\xBB\xBF{\"\xC3\xA9\": \"\xE2\x82\xAC\", \"b\": 1}", "a.json");
    expect_at(document, "/b", 1, 12);
}

TEST(document, keeps_the_order_of_members) {
    const Document document = parse_document(R"({"z": 1, "a": 2})", "a.json");
    EXPECT_EQ(document.json.dump(), R"({"z":1,"a":2})");
}

TEST(document, reports_keys_given_twice_with_both_lines) {
    const Document document = parse_document("{\n\"a\": 1,\n\"b\": {\"a\": 2},\n \"a\": 3}", "a.json");
    EXPECT_EQ(document.mistakes.text(), "a.json:4:2: error: /a: given twice: on line 2 and on line 4");
    const Document objects = parse_document("{\"a\": {\"b\": 1},\n \"a\": {\"b\": 2}}", "a.json");
    EXPECT_EQ(objects.mistakes.text(), "a.json:2:2: error: /a: given twice: on line 1 and on line 2");
    expect_at(objects, "/a/b", 2, 8);
}

TEST(document, says_where_syntax_is_wrong) {
    EXPECT_EQ(error_of("{\n  \"a\": 1\n  \"b\": 2\n}").substr(0, 42),
              "a.json:3:3: error: not valid JSON: unexpec");
    EXPECT_EQ(error_of("[1,,2]").substr(0, 34), "a.json:1:4: error: not valid JSON:");
    EXPECT_EQ(error_of("{\"a\": 1,}").substr(0, 34), "a.json:1:9: error: not valid JSON:");
    EXPECT_EQ(error_of("{\"a\": [1, 2").substr(0, 11), "a.json:1:12");
    EXPECT_EQ(error_of("{} x").substr(0, 10), "a.json:1:4");
    EXPECT_EQ(error_of("").substr(0, 10), "a.json:1:1");
    EXPECT_NE(error_of("{\"a\": 1,}").find("'}'"), std::string::npos);
    EXPECT_EQ(error_of("[1e999]").substr(0, 34), "a.json:1:2: error: not valid JSON:");
}

TEST(document, reads_a_file_or_says_that_it_cannot) {
    try {
        read_document("no_such_file.json");
        FAIL();
    } catch (const InputError& e) {
        EXPECT_STREQ(e.what(), "no_such_file.json: error: there is no such file");
    }
    EXPECT_THROW(read_document("."), InputError);
    const std::string file = ::testing::TempDir() + "config_document_test.json";
    std::ofstream(file) << "{\"a\": 1}";
    EXPECT_EQ(read_document(file).json, (Json{{"a", 1}}));
    std::remove(file.c_str());
}

TEST(document, locates_what_is_missing_at_the_object_around_it) {
    const Document document = parse_document("{\n \"a\": {}}", "a.json");
    EXPECT_EQ(to_string(document.diagnostic("/a/b/c", "wrong")), "a.json:2:2: error: /a/b/c: wrong");
}

std::string set(Document& document, std::string_view assignment) {
    Diagnostics diagnostics;
    apply_set(document, assignment, diagnostics);
    return diagnostics.text();
}

TEST(set, changes_and_creates_values) {
    Document document = parse_document(R"({"time": {"end": 1}, "list": [1, 2]})", "a.json");
    EXPECT_EQ(set(document, "/time/end=0.5"), "");
    EXPECT_EQ(set(document, "/time/step=1 ms"), "");
    EXPECT_EQ(set(document, "/list/1={\"a\": [true]}"), "");
    EXPECT_EQ(set(document, "/list/-=x=y"), "");
    EXPECT_EQ(set(document, "/new~1key=null"), "");
    EXPECT_EQ(document.json.dump(),
              R"({"time":{"end":0.5,"step":"1 ms"},"list":[1,{"a":[true]},"x=y"],"new/key":null})");
}

TEST(set, reaches_into_what_is_left_to_its_defaults) {
    Document document = parse_document(R"({"time": {"end": 1}})", "a.json");
    EXPECT_EQ(set(document, "/integrator/type=usl"), "");
    EXPECT_EQ(set(document, "/nonsense/deep/type=1"), "");
    EXPECT_EQ(document.json.dump(),
              R"({"time":{"end":1},"integrator":{"type":"usl"},"nonsense":{"deep":{"type":1}}})");
    EXPECT_EQ(to_string(document.diagnostic("/nonsense", "unknown key")),
              "--set /nonsense: error: /nonsense: unknown key");
}

TEST(set, is_named_as_the_place_of_mistakes) {
    Document document = parse_document(R"({"time": {"end": {"a": 1}}})", "a.json");
    EXPECT_EQ(set(document, "/time/end={\"b\": 1}"), "");
    EXPECT_EQ(to_string(document.diagnostic("/time/end/b", "wrong")),
              "--set /time/end: error: /time/end/b: wrong");
    EXPECT_EQ(to_string(document.diagnostic("/time", "wrong")), "a.json:1:2: error: /time: wrong");
}

TEST(set, refuses_pointers_that_lead_nowhere) {
    Document document = parse_document(R"({"time": {"end": 1}, "list": [1]})", "a.json");
    EXPECT_EQ(set(document, "/tme/end=1"),
              "--set /tme/end: error: /tme: there is nothing at this pointer; did you mean \"/time\"?");
    EXPECT_NE(set(document, "/time/end/x=1"), "");
    EXPECT_NE(set(document, "/list/5=1"), "");
    EXPECT_NE(set(document, "/list/x=1"), "");
    EXPECT_EQ(set(document, "time=1"), "--set time: error: expected /json/pointer=VALUE");
    EXPECT_EQ(set(document, "/time"), "--set /time: error: expected /json/pointer=VALUE");
    EXPECT_EQ(document.json.dump(), R"({"time":{"end":1},"list":[1]})");
}

TEST(document, refuses_nesting_that_would_eat_memory) {
    EXPECT_EQ(error_of(std::string(256, '[') + std::string(256, ']')), "no error");
    const std::string deep = error_of("{\"a\":\n" + std::string(1000000, '['));
    EXPECT_EQ(deep.substr(0, deep.find('\n')), "a.json:2:256: error: nested deeper than 256 levels");
}

}  // namespace
}  // namespace matpoint
