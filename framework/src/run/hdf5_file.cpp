#include "run/hdf5_file.hpp"

#include <algorithm>
#include <type_traits>

namespace matpoint::hdf5 {

namespace {

template <class T>
hid_t type_of() {
    if constexpr (std::is_same_v<T, char>) return H5T_NATIVE_CHAR;
    if constexpr (std::is_same_v<T, int>) return H5T_NATIVE_INT;
    if constexpr (std::is_same_v<T, std::uint32_t>) return H5T_NATIVE_UINT32;
    if constexpr (std::is_same_v<T, std::int64_t>) return H5T_NATIVE_INT64;
    if constexpr (std::is_same_v<T, float>) return H5T_NATIVE_FLOAT;
    if constexpr (std::is_same_v<T, double>) return H5T_NATIVE_DOUBLE;
}

template <class T>
void write_scalar_attribute(hid_t object, const std::string& name, hid_t type, const T* value) {
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    check(H5Awrite(attribute, type, value));
}

template <class T>
T read_scalar_attribute(hid_t object, const std::string& name) {
    const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose);
    const Handle space(H5Aget_space(attribute), H5Sclose);
    if (H5Sget_simple_extent_npoints(space) != 1) throw Error("the attribute " + name + " is not one number");
    T value{};
    check(H5Aread(attribute, type_of<T>(), &value));
    return value;
}

/// Times of creation would make the bytes differ from run to run.
Handle without_times(hid_t property_class) {
    Handle list(H5Pcreate(property_class), H5Pclose);
    check(H5Pset_obj_track_times(list, 0));
    return list;
}

Handle access_properties() {
    Handle list(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    // Texts of more than 64 KiB may be attributes in the newer format only.
    check(H5Pset_libver_bounds(list, H5F_LIBVER_V110, H5F_LIBVER_V110));
    // Network file systems may know no locks.
    check(H5Pset_file_locking(list, false, true));
    return list;
}

Handle string_type(std::size_t size) {
    Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    check(H5Tset_size(type, size));
    check(H5Tset_strpad(type, H5T_STR_NULLPAD));
    return type;
}

}  // namespace

void throw_last_error() {
    std::string text;
    const auto take_first = [](unsigned number, const H5E_error2_t* error, void* to) -> herr_t {
        if (number == 0 && error->desc) *static_cast<std::string*>(to) = error->desc;
        return 0;
    };
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_first, &text);
    throw Error(text.empty() ? "HDF5 gave no reason" : text);
}

Handle MemoryFile::create(Image& image, std::size_t user_block) {
    // HDF5 enlarges the image through these, and leaves it to its owner at the end.
    H5FD_file_image_callbacks_t callbacks{};
    callbacks.image_realloc = [](void* old, std::size_t size, H5FD_file_image_op_t, void* owner) -> void* {
        void* const bytes = std::realloc(old, size);
        if (bytes) {
            static_cast<Image*>(owner)->bytes = bytes;
            static_cast<Image*>(owner)->size = size;
        }
        return bytes;
    };
    callbacks.image_free = [](void*, H5FD_file_image_op_t, void*) -> herr_t { return 0; };
    callbacks.udata_copy = [](void* owner) { return owner; };
    callbacks.udata_free = [](void*) -> herr_t { return 0; };
    callbacks.udata = &image;

    constexpr std::size_t increment = 64 * 1024;
    const Handle access = access_properties();
    check(H5Pset_fapl_core(access, increment, false));
    check(H5Pset_file_image_callbacks(access, &callbacks));
    const Handle creation = without_times(H5P_FILE_CREATE);
    check(H5Pset_userblock(creation, user_block));
    return {H5Fcreate("image", H5F_ACC_TRUNC, creation, access), H5Fclose};
}

MemoryFile::MemoryFile(std::size_t user_block) : file_(create(image_, user_block)) {}

std::span<char> MemoryFile::finish() {
    file_.close();
    return {static_cast<char*>(image_.bytes), image_.size};
}

Handle open_file(const std::string& path) {
    return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, access_properties()), H5Fclose};
}

Handle create_group(hid_t parent, const std::string& name) {
    const Handle creation = without_times(H5P_GROUP_CREATE);
    return {H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, creation, H5P_DEFAULT), H5Gclose};
}

Handle open_group(hid_t parent, const std::string& name) {
    return {H5Gopen2(parent, name.c_str(), H5P_DEFAULT), H5Gclose};
}

void write_attribute(hid_t object, const std::string& name, const std::string& text) {
    // A string type has at least one character.
    const Handle type = string_type(std::max<std::size_t>(text.size(), 1));
    write_scalar_attribute(object, name, type, text.c_str());
}

void write_attribute(hid_t object, const std::string& name, double value) {
    write_scalar_attribute(object, name, type_of<double>(), &value);
}

void write_attribute(hid_t object, const std::string& name, std::int64_t value) {
    write_scalar_attribute(object, name, type_of<std::int64_t>(), &value);
}

std::string read_text(hid_t object, const std::string& name) {
    const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose);
    const Handle type(H5Aget_type(attribute), H5Tclose);
    if (H5Tget_class(type) != H5T_STRING || check(H5Tis_variable_str(type)))
        throw Error("the attribute " + name + " is not a text");
    std::string text(H5Tget_size(type), '\0');
    check(H5Aread(attribute, string_type(text.size()), text.data()));
    text.resize(std::min(text.size(), text.find('\0')));
    return text;
}

double read_number(hid_t object, const std::string& name) {
    return read_scalar_attribute<double>(object, name);
}

std::int64_t read_integer(hid_t object, const std::string& name) {
    return read_scalar_attribute<std::int64_t>(object, name);
}

std::vector<std::string> attribute_names(hid_t object) {
    std::vector<std::string> names;
    const auto add = [](hid_t, const char* name, const H5A_info_t*, void* to) -> herr_t {
        static_cast<std::vector<std::string>*>(to)->emplace_back(name);
        return 0;
    };
    check(H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names));
    return names;
}

template <class T>
void write_list(hid_t parent, const std::string& name, const T* values, std::size_t count) {
    const hsize_t size = count;
    const Handle creation = without_times(H5P_DATASET_CREATE);
    const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
    Handle list(H5Dcreate2(parent, name.c_str(), type_of<T>(), space, H5P_DEFAULT, creation, H5P_DEFAULT),
                H5Dclose);
    if (count > 0) check(H5Dwrite(list, type_of<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
    list.close();
}

template <class T>
std::vector<T> read_list(hid_t parent, const std::string& name) {
    const Handle list(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), H5Dclose);
    const Handle space(H5Dget_space(list), H5Sclose);
    std::vector<T> values(static_cast<std::size_t>(check(H5Sget_simple_extent_npoints(space))));
    if (!values.empty()) check(H5Dread(list, type_of<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
    return values;
}

template <class T>
bool holds(hid_t parent, const std::string& name) {
    const Handle list(H5Dopen2(parent, name.c_str(), H5P_DEFAULT), H5Dclose);
    const Handle type(H5Dget_type(list), H5Tclose);
    const Handle native(H5Tget_native_type(type, H5T_DIR_ASCEND), H5Tclose);
    return check(H5Tequal(native, type_of<T>())) > 0;
}

#define MATPOINT_HDF5_LIST(T)                                                      \
    template void write_list<T>(hid_t, const std::string&, const T*, std::size_t); \
    template std::vector<T> read_list<T>(hid_t, const std::string&);
MATPOINT_HDF5_LIST(char)
MATPOINT_HDF5_LIST(int)
MATPOINT_HDF5_LIST(std::uint32_t)
MATPOINT_HDF5_LIST(std::int64_t)
MATPOINT_HDF5_LIST(float)
MATPOINT_HDF5_LIST(double)
#undef MATPOINT_HDF5_LIST
template bool holds<float>(hid_t, const std::string&);

}  // namespace matpoint::hdf5
