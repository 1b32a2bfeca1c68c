/** Conversion between a state and the fragment of an address, so that a link restores the state. */

import { fileOf, initialState } from "./case.js";

/** The fragment for a state: its differences from the initial state, as JSON in base64. */
export function fragmentOf(state) {
  const initial = initialState();
  const changed = Object.entries(state).filter(
    ([name, value]) => JSON.stringify(value) !== JSON.stringify(initial[name]),
  );
  if (changed.length === 0) return "";
  const bytes = new TextEncoder().encode(JSON.stringify(Object.fromEntries(changed)));
  const text = btoa(String.fromCharCode(...bytes));
  return `#${text.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")}`;
}

/** The state for a fragment, or null if the fragment does not describe a state. */
export function stateOfFragment(fragment) {
  try {
    const text = fragment.slice(1).replaceAll("-", "+").replaceAll("_", "/");
    const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
    const changed = JSON.parse(new TextDecoder().decode(bytes));
    const initial = initialState();
    const known =
      changed !== null && typeof changed === "object" && Object.keys(changed).every((name) => name in initial);
    return fragment.length > 1 && known && hasCase({ ...initial, ...changed }) ? { ...initial, ...changed } : null;
  } catch {
    return null; // not base64, not JSON, or not a state
  }
}

/** Whether a state describes a case: missing numbers and unknown units become null in its JSON. */
export function hasCase(state) {
  return !JSON.stringify(fileOf(state)).includes(":null");
}
