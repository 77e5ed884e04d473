# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DSOURCE_DIR=... -DTEMPLATE=... -DOUTPUT=... -DSHAPEGAUGE_VERSION=... -P WriteVersion.cmake
#
# Writes OUTPUT from TEMPLATE with the version and the git commit of SOURCE_DIR; leaves the file alone when nothing
# changed. It runs at every build, because the commit may have moved since CMake was last run.
set(SHAPEGAUGE_COMMIT unknown)
find_program(GIT git)
if(GIT AND EXISTS ${SOURCE_DIR}/.git)
  # safe.directory: for a build as root of a checkout owned by a user. No optional locks: a build must not block a
  # commit.
  set(git ${GIT} --no-optional-locks -c safe.directory=${SOURCE_DIR} -C ${SOURCE_DIR})
  execute_process(COMMAND ${git} describe --always --abbrev=40 --exclude=* --dirty
                  OUTPUT_VARIABLE description OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed ERROR_QUIET)
  if(NOT failed)
    set(SHAPEGAUGE_COMMIT ${description})
  endif()
endif()
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
