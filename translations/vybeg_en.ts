<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US" sourcelanguage="en">
    <context>
        <name>Finding</name>
        <message numerus="yes">
            <source>(And %n more of the kind.)</source>
            <translation>
                <numerusform>(And %n more of the kind.)</numerusform>
                <numerusform>(And %n more of the kind.)</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>(And %n more place(s).)</source>
            <translation>
                <numerusform>(And %n more place.)</numerusform>
                <numerusform>(And %n more places.)</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>(And %n more place(s); %1 samples in all.)</source>
            <translation>
                <numerusform>(And %n more place; %1 samples in all.)</numerusform>
                <numerusform>(And %n more places; %1 samples in all.)</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n more</source>
            <translation>
                <numerusform>%n more</numerusform>
                <numerusform>%n more</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>Format</name>
        <message numerus="yes">
            <source>%n channel(s)</source>
            <translation>
                <numerusform>%n channel</numerusform>
                <numerusform>%n channels</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n column(s)</source>
            <translation>
                <numerusform>%n column</numerusform>
                <numerusform>%n columns</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>PlotStack</name>
        <message numerus="yes">
            <source>%n not drawn: other length or unit</source>
            <translation>
                <numerusform>%n not drawn: other length or unit</numerusform>
                <numerusform>%n not drawn: other length or unit</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>vybeg::ui::BatchWindow</name>
        <message numerus="yes">
            <source>%1 of %n set(s)</source>
            <translation>
                <numerusform>%1 of %n set</numerusform>
                <numerusform>%1 of %n sets</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n without a result</source>
            <translation>
                <numerusform>%n without a result</numerusform>
                <numerusform>%n without a result</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>vybeg::ui::CheckList</name>
        <message numerus="yes">
            <source>Recording check: %n finding(s)</source>
            <translation>
                <numerusform>Recording check: %n finding</numerusform>
                <numerusform>Recording check: %n findings</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>vybeg::ui::RecordingStore</name>
        <message numerus="yes">
            <source>%n more finding(s) in the recording check.</source>
            <translation>
                <numerusform>%n more finding in the recording check.</numerusform>
                <numerusform>%n more findings in the recording check.</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>vybeg::ui::FindingsFlag</name>
        <message numerus="yes">
            <source>%1: %n event(s)</source>
            <translation>
                <numerusform>%1: %n event</numerusform>
                <numerusform>%1: %n events</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>vybeg::ui::ResonatorPage</name>
        <message numerus="yes">
            <source>%1; %n recording(s)</source>
            <translation>
                <numerusform>%1; %n recording</numerusform>
                <numerusform>%1; %n recordings</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>Measuring</name>
        <message numerus="yes">
            <source>%n window(s) without common samples</source>
            <translation>
                <numerusform>%n window without common samples</numerusform>
                <numerusform>%n windows without common samples</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>LedgerRows</name>
        <message numerus="yes">
            <source>The frequency of %n window(s) lies at the bound of the search; the mean's deviation allows for them.</source>
            <translation>
                <numerusform>The frequency of %n window lies at the bound of the search; the mean's deviation allows for it.</numerusform>
                <numerusform>The frequency of %n windows lies at the bound of the search; the mean's deviation allows for them.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n window(s), %1 flagged, in %2</source>
            <translation>
                <numerusform>%n window, %1 flagged, in %2</numerusform>
                <numerusform>%n windows, %1 flagged, in %2</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%1 s, %n sample(s)</source>
            <translation>
                <numerusform>%1 s, %n sample</numerusform>
                <numerusform>%1 s, %n samples</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>vybeg::ui::StatusLine</name>
        <message numerus="yes">
            <source>%n window(s) in %1</source>
            <translation>
                <numerusform>%n window in %1</numerusform>
                <numerusform>%n windows in %1</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>Resonator of %n recording(s) in %1</source>
            <translation>
                <numerusform>Resonator of %n recording in %1</numerusform>
                <numerusform>Resonator of %n recordings in %1</numerusform>
            </translation>
        </message>
    </context>
<context>
    <name>vybeg::ui::ResidualsPage</name>
    <message numerus="yes">
        <source>%n line(s) above the noise: choose one</source>
        <translation>
            <numerusform>%n line above the noise: choose one</numerusform>
            <numerusform>%n lines above the noise: choose one</numerusform>
        </translation>
    </message>
</context>
    <context>
        <name>History</name>
        <message numerus="yes">
            <source>%n result(s) without a date are not shown; by order they are.</source>
            <translation>
                <numerusform>%n result without a date is not shown; by order it is.</numerusform>
                <numerusform>%n results without a date are not shown; by order they are.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>The first %n result(s) set the limits.</source>
            <translation>
                <numerusform>The first %n result sets the limits.</numerusform>
                <numerusform>The first %n results set the limits.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n result(s) of all gyros.</source>
            <translation>
                <numerusform>%n result of all gyros.</numerusform>
                <numerusform>%n results of all gyros.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>⚠ %n result(s) break the limits of the gyro.</source>
            <translation>
                <numerusform>⚠ %n result breaks the limits of the gyro.</numerusform>
                <numerusform>⚠ %n results break the limits of the gyro.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>None of %n result(s) is outside the control limits.</source>
            <translation>
                <numerusform>The one result is inside the control limits.</numerusform>
                <numerusform>None of %n results is outside the control limits.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n result(s) outside the control limits:</source>
            <translation>
                <numerusform>%n result outside the control limits:</numerusform>
                <numerusform>%n results outside the control limits:</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>and %n more</source>
            <translation>
                <numerusform>and %n more</numerusform>
                <numerusform>and %n more</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>vybeg::ui::MessageBar</name>
        <message numerus="yes">
            <source>%n more message(s)</source>
            <translation>
                <numerusform>%n more message</numerusform>
                <numerusform>%n more messages</numerusform>
            </translation>
        </message>
    </context>
    <context>
        <name>vybeg::ui::SessionKeeper</name>
        <message numerus="yes">
            <source>A session was not closed, and can be recovered: %1, %n recording(s), %2.</source>
            <translation>
                <numerusform>A session was not closed, and can be recovered: %1, %n recording, %2.</numerusform>
                <numerusform>A session was not closed, and can be recovered: %1, %n recordings, %2.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>Session %1 of %2 that were not closed: %3, %n recording(s), %4.</source>
            <translation>
                <numerusform>Session %1 of %2 that were not closed: %3, %n recording, %4.</numerusform>
                <numerusform>Session %1 of %2 that were not closed: %3, %n recordings, %4.</numerusform>
            </translation>
        </message>
    </context>
</TS>
