#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh ENVIRONMENT TEST ARGUMENT...: a test by the Python of the environment; exit code 77, a skip, if the package
# is not installed there.
environment=$1 test=$2
shift 2
if [[ ! -f $environment/installed ]]; then
  echo "the package is not installed: see the test 'python: install'"
  exit 77
fi
exec "$environment/bin/python" -B "$(dirname "$0")/$test.py" "$@"
