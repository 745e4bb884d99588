#pragma once

#include <hdf5.h>

#include <cstdint>
#include <cstdlib>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

/// The little of HDF5's C interface that checkpoints use, with handles that close themselves and
/// failures as exceptions.
namespace matpoint::hdf5 {

/// HDF5's own reason for a failure.
class Error : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

[[noreturn]] void throw_last_error();

/// Throws Error if an HDF5 function says that it failed; returns its value otherwise.
template <class Value>
Value check(Value value) {
    if (value < 0) throw_last_error();
    return value;
}

/// Keeps HDF5 from printing its errors while it lives.
class Quiet {
  public:
    Quiet() {
        H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    }
    ~Quiet() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;

  private:
    H5E_auto2_t function_ = nullptr;
    void* data_ = nullptr;
};

class Handle {
  public:
    using Close = herr_t (*)(hid_t);
    Handle(hid_t id, Close close_function) : id_(check(id)), close_(close_function) {}
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
    Handle& operator=(Handle&&) = delete;
    ~Handle() {
        if (id_ >= 0) close_(id_);
    }
    operator hid_t() const { return id_; }
    /// Closing may fail, as it writes what is left to write.
    void close() { check(close_(std::exchange(id_, -1))); }

  private:
    hid_t id_;
    Close close_;
};

/// A new file that HDF5 builds in memory; its bytes depend on the contents alone. Putting them on a
/// disk is left to the caller, because HDF5 1.10 does not survive a disk that is full: it loses
/// handles and crashes at exit. `user_block` bytes (0, 512, 1024, …) at its beginning are free.
class MemoryFile {
  public:
    explicit MemoryFile(std::size_t user_block = 0);
    operator hid_t() const { return file_; }
    /// Ends the writing.
    std::span<char> finish();

  private:
    struct Image {
        Image() = default;
        Image(const Image&) = delete;
        Image& operator=(const Image&) = delete;
        ~Image() { std::free(bytes); }
        void* bytes = nullptr;
        std::size_t size = 0;
    };
    static Handle create(Image& image, std::size_t user_block);

    Image image_;  // outlives file_
    Handle file_;
};

Handle open_file(const std::string& path);

Handle create_group(hid_t parent, const std::string& name);
Handle open_group(hid_t parent, const std::string& name);

void write_attribute(hid_t object, const std::string& name, const std::string& text);
void write_attribute(hid_t object, const std::string& name, double value);
void write_attribute(hid_t object, const std::string& name, std::int64_t value);
std::string read_text(hid_t object, const std::string& name);
double read_number(hid_t object, const std::string& name);
std::int64_t read_integer(hid_t object, const std::string& name);
std::vector<std::string> attribute_names(hid_t object);

/// Lists of char, int, uint32_t, int64_t, float or double.
template <class T>
void write_list(hid_t parent, const std::string& name, const T* values, std::size_t count);
template <class T>
std::vector<T> read_list(hid_t parent, const std::string& name);
/// Whether the list was written from numbers of type T.
template <class T>
bool holds(hid_t parent, const std::string& name);

}  // namespace matpoint::hdf5
