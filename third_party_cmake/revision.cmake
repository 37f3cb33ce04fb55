# cmake -DSOURCE_DIR=... -DOUTPUT=header.h -P revision.cmake: names the commit that is being built, "unknown" outside git.
execute_process(COMMAND git -C ${SOURCE_DIR} rev-parse --short=12 HEAD
  OUTPUT_VARIABLE REVISION ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE FAILED)
if(FAILED)
  set(REVISION unknown)
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#define TORRANCE_REVISION \"${REVISION}\"\n")
