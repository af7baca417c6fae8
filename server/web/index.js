"use strict";
const kinds = [
  ["recipes", "recipes", "/v1/recipes"],
  ["robots", "robots", "/v1/robots"],
  ["environments", "environments", "/v1/environments"],
  ["object_models", "object models", "/v1/object-models"],
  ["priors", "tables of likely places", "/v1/priors"],
  ["ontology_modules", "ontology modules", "/v1/ontology/modules"],
  ["statements_asserted", "statements", "/v1/status"],
  ["statements_inferred", "inferred statements", "/v1/status"],
];

function card(count, label, link) {
  const element = document.createElement("a");
  element.className = "card";
  element.href = link;
  const number = document.createElement("b");
  number.textContent = Number(count).toLocaleString("en");
  element.append(number, label);
  return element;
}

async function show() {
  const line = document.getElementById("status");
  try {
    const answer = await fetch("/v1/status");
    if (answer.status === 401) {
      line.textContent = "This server answers questions only to those who show a token.";
      return;
    }
    const status = await answer.json();
    const cards = document.getElementById("cards");
    for (const [key, label, link] of kinds) cards.append(card(status.counts[key], label, link));
    const minutes = Math.floor(status.uptime_s / 60);
    line.textContent = `Version ${status.version}, up for ${minutes} min` +
      (status.writes_refused ? `. Writes are refused: ${status.writes_refused}` : ".");
  } catch (error) {
    line.textContent = `The server's status cannot be read: ${error.message}`;
  }
}

show();
