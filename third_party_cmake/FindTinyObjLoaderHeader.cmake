# tinyobjloader as one header, compiled by src/files itself, so that sanitizers see its code.
# Target: TinyObjLoaderHeader::TinyObjLoaderHeader.
find_path(TINYOBJLOADER_INCLUDE_DIR tiny_obj_loader.h)
mark_as_advanced(TINYOBJLOADER_INCLUDE_DIR)

if(TINYOBJLOADER_INCLUDE_DIR)
  # The header's list of changes begins with the newest: "// version 2.0.0 : Add new object oriented API. ..."
  file(STRINGS ${TINYOBJLOADER_INCLUDE_DIR}/tiny_obj_loader.h NEWEST REGEX "^// version [0-9.]+ " LIMIT_COUNT 1)
  string(REGEX MATCH "[0-9]+\\.[0-9]+\\.[0-9]+" TinyObjLoaderHeader_VERSION "${NEWEST}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(TinyObjLoaderHeader REQUIRED_VARS TINYOBJLOADER_INCLUDE_DIR
                                  VERSION_VAR TinyObjLoaderHeader_VERSION)

if(TinyObjLoaderHeader_FOUND AND NOT TARGET TinyObjLoaderHeader::TinyObjLoaderHeader)
  add_library(TinyObjLoaderHeader::TinyObjLoaderHeader INTERFACE IMPORTED)
  set_target_properties(TinyObjLoaderHeader::TinyObjLoaderHeader PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${TINYOBJLOADER_INCLUDE_DIR})
endif()
