#pragma once

#include "apps/record/hdf5_api.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace swirl::apps::hdf5 {

/// Owns an HDF5 identifier. `Close` is the H5?close function of its kind.
template <herr_t (*Api::*Close)(hid_t)>
class Handle {
public:
    Handle() = default;
    explicit Handle(hid_t id) : id_(id) {}
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    ~Handle() { close(); }

    /// Negative when closing failed (data that could not be written show up here).
    herr_t close() {
        const hid_t id = std::exchange(id_, H5I_INVALID_HID);
        return id >= 0 ? (api().*Close)(id) : 0;
    }
    /// Leaves it open in the library for good.
    void abandon() { id_ = H5I_INVALID_HID; }
    [[nodiscard]] hid_t id() const { return id_; }
    [[nodiscard]] bool open() const { return id_ >= 0; }

private:
    hid_t id_ = H5I_INVALID_HID;
};

using File = Handle<&Api::H5Fclose>;
using Group = Handle<&Api::H5Gclose>;
using Dataset = Handle<&Api::H5Dclose>;
using Dataspace = Handle<&Api::H5Sclose>;
using Datatype = Handle<&Api::H5Tclose>;
using Attribute = Handle<&Api::H5Aclose>;
using Object = Handle<&Api::H5Oclose>;
using Properties = Handle<&Api::H5Pclose>;

/// Before every file: turns HDF5's own printing of errors off, for this thread; every failure becomes a RecordError.
void prepare();

/// The innermost message of HDF5's error stack; where it quotes the system's message, that alone.
std::string reason();

/// Throws RecordError(action, path, reason()) when `result`, an identifier or a status, is negative; else returns it.
template <class Result>
Result check(Result result, std::string_view action, std::string_view path);

/// A UTF-8 string of any length, as h5py and netCDF read it back as text.
Datatype string_type();

}  // namespace swirl::apps::hdf5
