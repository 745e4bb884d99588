#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// ParaView's list of the files of a series and their times (.pvd).
class PvdFile {
  public:
    /// Begins the list; if the run resumes at `resumed_at` >= 0, with the entries up to that time that
    /// the file has.
    void open(const std::filesystem::path& file, double resumed_at);
    /// Adds the files of a time and puts the whole list in place at once.
    void add(double time, const std::vector<std::string>& data_files);

    /// Number of times.
    std::size_t size() const { return entries_.size(); }
    bool ends_at(double time) const { return !entries_.empty() && entries_.back().time == time; }

  private:
    struct Entry {
        double time;  // s
        std::vector<std::string> data_files;
    };
    std::filesystem::path file_;
    std::vector<Entry> entries_;
};
