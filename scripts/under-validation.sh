#!/usr/bin/env bash
# Runs a command under Vulkan's validation layers, synchronization validation included. Fails when
# the command fails, when the layers have anything to say, or when no layer was ever active.
#
# usage: scripts/under-validation.sh COMMAND [ARGUMENT...]
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
log=$folder/log

# Each Vulkan instance opens the log anew and would empty a plain file: a pipe collects them all.
mkfifo "$folder/pipe"
cat "$folder/pipe" >"$log" &
exec 9>"$folder/pipe"

cat >"$folder/vk_layer_settings.txt" <<SETTINGS
khronos_validation.debug_action = VK_DBG_LAYER_ACTION_LOG_MSG
khronos_validation.report_flags = error,warn,perf,info
khronos_validation.log_filename = $folder/pipe
khronos_validation.enables = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT
SETTINGS

status=0
VK_LAYER_SETTINGS_PATH=$folder VK_INSTANCE_LAYERS=VK_LAYER_KHRONOS_validation ORGANZA_VALIDATION=1 \
  "$@" 9>&- || status=$?
exec 9>&-
wait

instances=$(grep -c 'Khronos Validation Layer Active' "$log") || true
if (( status )); then
  echo "error: '$*' failed under the validation layers" >&2
elif grep -qE '\((ERROR|WARN|PERF) / |Validation (Error|Warning|Performance)' "$log"; then
  echo "error: the validation layers complain:" >&2
  status=1
elif (( instances == 0 )); then
  echo "error: '$*' used no Vulkan, or its validation layers are not installed" >&2
  status=1
fi
if (( status )); then
  head -n 100 "$log" >&2
  exit "$status"
fi
echo "the validation layers watched $instances Vulkan instances, and are silent"
