#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# run.sh ENVIRONMENT TEST ARGUMENT...: a test by the Python of the environment; exit code 77, a skip, if there is none.
environment=$1 test=$2
shift 2
if [[ ! -f $environment/requirements.stamp ]]; then
  echo "the packages of studies/requirements.txt are not installed: see the test 'studies: environment'"
  exit 77
fi
exec "$environment/bin/python" -B "$(dirname "$0")/$test.py" "$@"
