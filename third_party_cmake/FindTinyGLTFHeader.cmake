# tinygltf as one header, compiled by src/files itself: Debian's library has a decoder of its own for images and would
# hide the header's code from the sanitizers. Target: TinyGLTFHeader::TinyGLTFHeader.
find_path(TINYGLTF_INCLUDE_DIR tiny_gltf.h)
mark_as_advanced(TINYGLTF_INCLUDE_DIR)

if(TINYGLTF_INCLUDE_DIR)
  # The header's list of changes begins with the newest: "//  - v2.7.0 Change WriteImageDataFunction ..."
  file(STRINGS ${TINYGLTF_INCLUDE_DIR}/tiny_gltf.h NEWEST REGEX "^//  - v[0-9.]+ " LIMIT_COUNT 1)
  string(REGEX MATCH "[0-9]+\\.[0-9]+\\.[0-9]+" TinyGLTFHeader_VERSION "${NEWEST}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(TinyGLTFHeader REQUIRED_VARS TINYGLTF_INCLUDE_DIR VERSION_VAR TinyGLTFHeader_VERSION)

if(TinyGLTFHeader_FOUND AND NOT TARGET TinyGLTFHeader::TinyGLTFHeader)
  add_library(TinyGLTFHeader::TinyGLTFHeader INTERFACE IMPORTED)
  set_target_properties(TinyGLTFHeader::TinyGLTFHeader PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${TINYGLTF_INCLUDE_DIR})
endif()
