#pragma once

// Internal to apps/record: with the .cpp files beside it, the only place that sees HDF5's C API. HDF5 is loaded as it
// is first asked for: it brings some forty libraries of its own (curl's, Kerberos's), which take longer than the rest
// of the program does to start, and most commands write no record.
#include <hdf5.h>
#include <hdf5_hl.h>

// These open the library wherever a constant is named; hdf5::api() does it once.
#undef H5OPEN
#define H5OPEN
#undef H5CHECK
#define H5CHECK

// clang-format off

/// Every function of HDF5 that is called.
#define SWIRL_HDF5_FUNCTIONS(X) \
    X(H5check_version) X(H5dont_atexit) X(H5is_library_threadsafe) X(H5open) \
    X(H5Aclose) X(H5Acreate2) X(H5Aexists) X(H5Aget_space) X(H5Aget_type) X(H5Aiterate2) X(H5Aopen) X(H5Aread) X(H5Awrite) \
    X(H5Dclose) X(H5Dcreate2) X(H5Dget_space) X(H5Dget_type) X(H5Dopen2) X(H5Dread) X(H5Dset_extent) X(H5Dvlen_reclaim) X(H5Dwrite) \
    X(H5DSattach_scale) X(H5DSget_scale_name) X(H5DSis_scale) X(H5DSiterate_scales) X(H5DSset_scale) \
    X(H5Eset_auto2) X(H5Ewalk2) \
    X(H5Fclose) X(H5Fcreate) X(H5Fflush) X(H5Fis_hdf5) X(H5Fopen) \
    X(H5Gclose) X(H5Gcreate2) X(H5Gopen2) X(H5Iget_name) X(H5Iget_type) X(H5Literate) \
    X(H5Oclose) X(H5Oexists_by_name) X(H5Oopen) \
    X(H5Pclose) X(H5Pcreate) X(H5Pset_char_encoding) X(H5Pset_chunk) X(H5Pset_chunk_cache) X(H5Pset_deflate) \
    X(H5Pset_file_locking) X(H5Pset_libver_bounds) X(H5Pset_obj_track_times) X(H5Pset_shuffle) \
    X(H5Sclose) X(H5Screate) X(H5Screate_simple) X(H5Sget_simple_extent_dims) X(H5Sget_simple_extent_ndims) \
    X(H5Sget_simple_extent_npoints) X(H5Sget_simple_extent_type) X(H5Sselect_hyperslab) \
    X(H5Tclose) X(H5Tcopy) X(H5Tget_class) X(H5Tget_sign) X(H5Tget_size) X(H5Tis_variable_str) X(H5Tset_cset) X(H5Tset_size)

/// Every identifier that is a variable of the library, by that variable.
#define SWIRL_HDF5_IDENTIFIERS(X) \
    X(H5T_C_S1_g) X(H5T_IEEE_F32BE_g) X(H5T_IEEE_F64LE_g) X(H5T_NATIVE_DOUBLE_g) X(H5T_NATIVE_INT32_g) X(H5T_NATIVE_INT64_g) \
    X(H5T_NATIVE_UINT64_g) X(H5T_NATIVE_UINT8_g) X(H5T_STD_I32LE_g) X(H5T_STD_I64LE_g) X(H5T_STD_U64LE_g) X(H5T_STD_U8LE_g) \
    X(H5P_CLS_ATTRIBUTE_CREATE_ID_g) X(H5P_CLS_DATASET_ACCESS_ID_g) X(H5P_CLS_DATASET_CREATE_ID_g) X(H5P_CLS_FILE_ACCESS_ID_g) \
    X(H5P_CLS_FILE_CREATE_ID_g) X(H5P_CLS_GROUP_CREATE_ID_g) X(H5P_CLS_LINK_CREATE_ID_g)

// clang-format on

namespace swirl::apps::hdf5 {

struct Api {
#define SWIRL_HDF5_MEMBER(name) decltype(&::name) name = nullptr;
    SWIRL_HDF5_FUNCTIONS(SWIRL_HDF5_MEMBER)
#undef SWIRL_HDF5_MEMBER
#define SWIRL_HDF5_MEMBER(name) hid_t name = H5I_INVALID_HID;
    SWIRL_HDF5_IDENTIFIERS(SWIRL_HDF5_MEMBER)
#undef SWIRL_HDF5_MEMBER
};

/// HDF5, loaded and opened by the first call; its clearing up at exit is turned off. Any thread may call it.
/// @throws RecordError where it can't be loaded
const Api& api();

}  // namespace swirl::apps::hdf5
