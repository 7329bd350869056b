// Begins the page.
import { applyTheme, onSystemTheme } from "./colours";
import { Connection } from "./connection";
import { mountShell } from "./shell";
import { mountStage } from "./stage";
import { Stats } from "./stats";
import { Store } from "./store";

const query = new URLSearchParams(location.search);
const user = Number(query.get("user"));
const token = new URLSearchParams(location.hash.slice(1)).get("token") || null;
const store = new Store(Number.isInteger(user) && user >= 1 ? user - 1 : null);
const theme = () => applyTheme(store.settings.theme);
theme();
store.on("settings", theme);
onSystemTheme(theme);

const stats = new Stats();
const connection = new Connection(store, token, `${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/ws`);
connection.onPoint = (number, time) => stats.pointed(number, time);
const shell = mountShell(document.getElementById("app")!, store, connection);
const stage = mountStage(shell.stageElement, store, connection, stats);
shell.attach(stage);

declare global {
  interface Window {
    cotouch: { store: Store; connection: Connection; stage: ReturnType<typeof mountStage>; stats: Stats };
  }
}
window.cotouch = { store, connection, stage, stats };
