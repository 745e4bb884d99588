#pragma once

#include <matpoint/output.hpp>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace matpoint {

/// A number as text with at most `digits` significant digits. With 17 it is the shortest text that
/// reads back to the very same double.
std::string number_text(double value, int digits = 17);

/// A file that is written aside and gets its name when it is complete, so that a run that is killed
/// leaves the file that was there before, or none. Every failure throws std::runtime_error with the
/// file's name and the reason ("No space left on device").
class OutputFile {
  public:
    explicit OutputFile(std::filesystem::path file);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(std::string_view text);
    /// Gives the file its name.
    void commit();

  private:
    std::filesystem::path file_, aside_;
    std::ofstream stream_;
};

/// A CSV table that grows by a row at each write; its first column is the time (s). Failures throw
/// as those of OutputFile do, and so does a table that somebody removed or changed meanwhile. It is open
/// while a row is written only, so that a run may have more tables than files may be open.
class TimeTable {
  public:
    /// Begins the table. If the run resumes at `resumed_at` >= 0 and the file is there, its rows up to
    /// that time stay; throws std::runtime_error if they have other columns.
    void open(const std::filesystem::path& file, const std::vector<std::string>& columns, double resumed_at);
    /// A row that reaches the disk at once. A time that the last row has already is left out: a run
    /// may end, or resume, at a time that was written before.
    void append(double time, const std::vector<std::string>& values);
    std::size_t rows() const { return rows_; }
    bool ends_at(double time) const { return rows_ > 0 && last_time_ == time; }

  private:
    std::filesystem::path file_;
    std::uintmax_t size_ = 0;  ///< bytes, as this class left them
    std::size_t rows_ = 0;
    double last_time_ = 0;
};

/// Adds the parameter `name` of an output that names its files by it: letters, digits, _ - and dots.
/// `files` are those that it writes, as Schema::writes has them: "<name>.csv".
void add_file_name(Schema& schema, ParameterOptions options, const std::vector<std::string>& files);

/// Removes the files `before`<number>`after` of a folder with numbers from `first` on, finished or not: what
/// an earlier run wrote there, or the run that resumes wrote after its checkpoint.
void remove_numbered(const std::filesystem::path& folder, const std::string& before, const std::string& after,
                     std::size_t first);

/// The bodies that an output sees: the one named, or all if the name is empty.
std::vector<std::string> observed_bodies(const RunView& run, const std::string& body);
bool has_field(const RunView& run, const std::string& body, const std::string& field);
/// Throws std::runtime_error with the fields there are, if none of the bodies carries the field.
void expect_field(const RunView& run, const std::vector<std::string>& bodies, const std::string& field);

}  // namespace matpoint
