"""Inside the coating: stress, loss, temperature, and what the heat changes."""
