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

/** A name as it stands in the source: `DOOR`, `P1IN.2`, `IP1.B3`. */
export const NAME = /[A-Za-z_?@][\w?@]*(\.[\w?@]+)?/;

/** The name that a menu stands for: of a variable, or of a row of the live view. */
export function nameInMenu(menu: VariableMenu | LiveRow | undefined): string | undefined {
  const name =
    (menu as LiveRow | undefined)?.watch?.port ??
    (menu as LiveRow | undefined)?.bit?.name ??
    (menu as VariableMenu | undefined)?.variable?.evaluateName;
  return name === "" ? undefined : name;
}

/** A row of the live view, as far as it is of use here. */
export interface LiveRow {
  watch?: { port?: string };
  bit?: { name: string };
}

/** What the user is asked when a command does not come from such a menu. */
export function question(value: ForceRequest["value"]): string {
  const what = value === null ? "let go" : `hold at ${value}`;
  return `Bit of a port to ${what}: its name, or the name the program copies it from or to`;
}
