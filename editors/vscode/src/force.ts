// Forcing of ports from the menu of a variable. Knows no editor.

/** What VS Code hands to a command in the menu of a variable, as far as it is of use here. */
export interface VariableMenu {
  sessionId?: string;
  variable?: { name?: string; evaluateName?: string };
}

/** Arguments of the request `technol/force`. */
export interface ForceRequest {
  name: string;
  /** `null`: forced no more. */
  value: 0 | 1 | null;
}

export const FORCE_COMMANDS: Record<string, ForceRequest["value"]> = {
  "technol.forceTo0": 0,
  "technol.forceTo1": 1,
  "technol.removeForce": null,
};

/** What to ask the debug adapter; `undefined` when the row has no name that it knows. */
export function forceRequest(menu: VariableMenu | undefined, value: ForceRequest["value"]): ForceRequest | undefined {
  const name = menu?.variable?.evaluateName;
  return name === undefined || name === "" ? undefined : { name, value };
}
