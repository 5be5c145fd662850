(2: N: Übertragung falsch, richtig: P0001N001. Daten prüfen, neu senden.)
N001 G17
N002 G18
