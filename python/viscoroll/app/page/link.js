/** The state in the fragment of an address, by which a link restores it. */

import { caseOf, initialState } from "./case.js";

/** The fragment of a state: what of it is not as at the beginning, as base64 of its JSON. */
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

/** The state of a fragment, or null where it is none of ours. */
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
    return null; // no base64, no JSON, or no state
  }
}

/** Whether a state describes a case: what has no number, or a unit that is none, is null in its JSON. */
function hasCase(state) {
  return !JSON.stringify(caseOf(state)).includes(":null");
}
